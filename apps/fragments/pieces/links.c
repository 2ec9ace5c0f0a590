#include "apps/fragments/pieces/links.h"

#include "apps/base/mesh_places.h"

#include <stdlib.h>

/* An edge of a face, by its ends. */
typedef struct Edge {
    uint32_t low, high; /* places */
    uint32_t corner;    /* 3 * face + corner where it begins */
} Edge;

static int compare_edges(const void *a, const void *b)
{
    const Edge *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return (p->corner > q->corner) - (p->corner < q->corner);
}

static uint32_t next_corner(uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/* Edges of one pair of places, [0, count). */
static void link_edges(const Edge *edges, uint32_t count, FaceLinks *links)
{
    if (count == 1)
        links->boundary_edges++;
    else if (count > 2)
        links->non_manifold_edges++;
    else if (links->places[edges[0].corner] == links->places[edges[1].corner])
        links->turned_edges++;
    else
        for (int i = 0; i < 2; i++)
            links->across[edges[i].corner] = edges[1 - i].corner / 3;
}

static bool has_three_corners(const uint32_t corner[3])
{
    return corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0];
}

static GpResult find_across(FaceLinks *links)
{
    Edge *edges = gp_alloc(3 * (size_t)links->face_count, sizeof *edges);
    uint32_t count = 0;
    if (!edges)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < 3 * links->face_count; i++) {
        const uint32_t from = links->places[i], to = links->places[next_corner(i)];
        links->across[i] = NO_FACE;
        if (has_three_corners(links->places + (i - i % 3)))
            edges[count++] = (Edge){ from < to ? from : to, from < to ? to : from, i };
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    for (uint32_t i = 0, end; i < count; i = end) {
        for (end = i + 1;
             end < count && edges[end].low == edges[i].low && edges[end].high == edges[i].high;
             end++)
            ;
        link_edges(edges + i, end - i, links);
    }
    gp_free(edges);
    return GP_OK;
}

static void find_faces(FaceLinks *links)
{
    uint32_t *next =
        links->first + 1; /* counts, then where a place's next face goes, then its end */
    for (uint32_t i = 0; i < 3 * links->face_count; i++)
        next[links->places[i] + 1]++;
    for (uint32_t p = 0; p < links->place_count; p++)
        next[p + 1] += next[p];
    for (uint32_t i = 0; i < 3 * links->face_count; i++)
        links->faces[next[links->places[i]]++] = i / 3;
}

GpResult links_make(const float (*positions)[3], uint32_t vertex_count, const uint32_t *indices,
                    uint32_t face_count, FaceLinks *links, GpError *error)
{
    const size_t corners = 3 * (size_t)face_count;
    uint32_t *place_of = gp_alloc(vertex_count, sizeof *place_of);
    FaceLinks made = { .face_count = face_count,
                       .places = gp_alloc(corners, sizeof(uint32_t)),
                       .across = gp_alloc(corners, sizeof(uint32_t)),
                       .faces = gp_alloc(corners, sizeof(uint32_t)),
                       .first = gp_alloc((size_t)vertex_count + 2, sizeof(uint32_t)) };
    bool done = place_of && made.places && made.across && made.faces && made.first &&
                !mesh_places(&positions[0][0], vertex_count, place_of);
    for (size_t i = 0; i < corners && done; i++) {
        made.places[i] = place_of[indices[i]];
        if (made.places[i] >= made.place_count)
            made.place_count = made.places[i] + 1;
    }
    done = done && !find_across(&made);
    gp_free(place_of);
    if (!done) {
        links_free(&made);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    find_faces(&made);
    *links = made;
    return GP_OK;
}

void links_free(FaceLinks *links)
{
    gp_free(links->places);
    gp_free(links->across);
    gp_free(links->faces);
    gp_free(links->first);
    *links = (FaceLinks){ .face_count = 0 };
}
