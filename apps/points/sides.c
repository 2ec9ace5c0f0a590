#include "apps/points/sides.h"

#include "apps/base/vector.h"
#include "apps/points/cloud/distinct.h"

#include <string.h>

enum { SEVERAL = UINT32_MAX - 1 };

/* first: [edges->count], NO_SIDE throughout */
static void pair_sides(const Edges *edges, size_t count, uint32_t *first, uint32_t *mate)
{
    for (size_t s = 0; s < count; s++) {
        uint32_t *other = &first[edges->of_side[s]];
        mate[s] = NO_SIDE;
        if (*other == NO_SIDE) {
            *other = (uint32_t)s;
        } else if (*other != SEVERAL && mate[*other] == NO_SIDE) {
            mate[s] = *other;
            mate[*other] = (uint32_t)s;
        } else if (*other != SEVERAL) { /* the third at this edge */
            mate[mate[*other]] = NO_SIDE;
            mate[*other] = NO_SIDE;
            *other = SEVERAL;
        }
    }
}

/* Indices of the first vertices at the vertices' places. */
static GpResult weld(const GpMesh *mesh, uint32_t *corners)
{
    uint32_t *first = gp_alloc_unset(mesh->vertex_count * sizeof *first + 1);
    GpResult result = first ? GP_OK : GP_ERROR_MEMORY;
    if (result == GP_OK)
        result = places_find(mesh->positions, mesh->vertex_count, first);
    for (size_t i = 0; result == GP_OK && i < 3 * (size_t)mesh->triangle_count; i++)
        corners[i] = first[mesh->indices[i]];
    gp_free(first);
    return result;
}

GpResult sides_find(const GpMesh *mesh, Sides *sides)
{
    const size_t count = 3 * (size_t)mesh->triangle_count;
    Sides found = { .corners = gp_alloc_unset(count * sizeof(uint32_t) + 1),
                    .mate = gp_alloc_unset(count * sizeof(uint32_t) + 1) };
    uint32_t *first = NULL;
    GpResult result = found.corners && found.mate ? weld(mesh, found.corners) : GP_ERROR_MEMORY;
    if (result == GP_OK) {
        GpMesh welded = *mesh;
        welded.indices = found.corners;
        result = edges_find(&welded, &found.edges);
    }
    if (result == GP_OK) {
        first = gp_alloc_unset(found.edges.count * sizeof *first + 1);
        result = first ? GP_OK : GP_ERROR_MEMORY;
    }
    if (result == GP_OK) {
        memset(first, 0xff, found.edges.count * sizeof *first); /* NO_SIDE */
        pair_sides(&found.edges, count, first, found.mate);
        *sides = found;
    } else {
        sides_free(&found);
    }
    gp_free(first);
    return result;
}

void sides_free(Sides *sides)
{
    gp_free(sides->corners);
    gp_free(sides->mate);
    edges_free(&sides->edges);
    *sides = (Sides){ .corners = NULL };
}

void triangle_cross(const GpMesh *mesh, size_t triangle, double cross[3])
{
    double edges[2][3];
    const uint32_t *corner = mesh->indices + 3 * triangle;
    for (int e = 0; e < 2; e++)
        for (size_t k = 0; k < 3; k++)
            edges[e][k] = (double)mesh->positions[3 * (size_t)corner[1 + e] + k] -
                          (double)mesh->positions[3 * (size_t)corner[0] + k];
    vector_cross(edges[0], edges[1], cross);
}
