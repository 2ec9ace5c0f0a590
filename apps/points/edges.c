#include "apps/points/edges.h"

#include <stdlib.h>

/* --- visiting --------------------------------------------------------------------------------- */

static int compare_keys(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return x < y ? -1 : x > y;
}

/* A vertex has few sides mostly, for which insertion is fastest; the hub of a large fan has not. */
static void sort_keys(uint64_t *keys, size_t count)
{
    if (count > 32) {
        qsort(keys, count, sizeof *keys, compare_keys);
        return;
    }
    for (size_t i = 1; i < count; i++) {
        const uint64_t key = keys[i];
        size_t at = i;
        for (; at > 0 && key < keys[at - 1]; at--)
            keys[at] = keys[at - 1];
        keys[at] = key;
    }
}

static void side_ends(const uint32_t *corners, size_t side, uint32_t ends[2])
{
    const uint32_t a = corners[side], b = corners[side_end(side)];
    ends[0] = a < b ? a : b;
    ends[1] = a < b ? b : a;
}

/* Lists the sides by lower vertex: those of v are sides[first[v]] .. sides[first[v + 1] - 1].
 * returns how many a vertex has at most */
static size_t list_sides(const GpMesh *mesh, const uint32_t *corners, size_t *first,
                         uint32_t *sides)
{
    const size_t side_count = 3 * (size_t)mesh->triangle_count;
    uint32_t ends[2];
    size_t most = 0;
    for (size_t s = 0; s < side_count; s++) {
        side_ends(corners, s, ends);
        first[ends[0] + 2]++;
    }
    for (size_t v = 2; v < (size_t)mesh->vertex_count + 2; v++) {
        most = first[v] > most ? first[v] : most;
        first[v] += first[v - 1];
    }
    for (size_t s = 0; s < side_count; s++) {
        side_ends(corners, s, ends);
        sides[first[ends[0] + 1]++] = (uint32_t)s;
    }
    return most;
}

/* The edges of one lower vertex.
 * in/out sides: of it, to be sorted
 * keys   [count] higher vertex, side */
static void visit_vertex(const uint32_t *corners, uint32_t *sides, size_t count, uint64_t *keys,
                         EdgeFn visit, void *context)
{
    uint32_t ends[2] = { 0 };
    for (size_t i = 0; i < count; i++) {
        side_ends(corners, sides[i], ends);
        keys[i] = (uint64_t)ends[1] << 32 | sides[i];
    }
    sort_keys(keys, count);
    for (size_t i = 0; i < count; i++)
        sides[i] = (uint32_t)keys[i];
    for (size_t i = 0, next; i < count; i = next) {
        ends[1] = (uint32_t)(keys[i] >> 32);
        for (next = i + 1; next < count && keys[next] >> 32 == ends[1];)
            next++;
        visit(context, ends, sides + i, next - i);
    }
}

GpResult edges_visit(const GpMesh *mesh, const uint32_t *corners, EdgeFn visit, void *context)
{
    const size_t side_count = 3 * (size_t)mesh->triangle_count;
    size_t *first = gp_alloc((size_t)mesh->vertex_count + 2, sizeof *first);
    uint32_t *sides = gp_alloc_unset(side_count * sizeof *sides + 1);
    uint64_t *keys = NULL;
    if (first && sides)
        keys = gp_alloc_unset(list_sides(mesh, corners, first, sides) * sizeof *keys + 1);
    for (size_t v = 0; keys && v < mesh->vertex_count; v++)
        visit_vertex(corners, sides + first[v], first[v + 1] - first[v], keys, visit, context);
    const GpResult result = keys ? GP_OK : GP_ERROR_MEMORY;
    gp_free(first);
    gp_free(sides);
    gp_free(keys);
    return result;
}

/* --- numbering -------------------------------------------------------------------------------- */

static void number_edge(void *context, const uint32_t ends[2], const uint32_t *sides, size_t count)
{
    Edges *edges = context;
    edges->ends[2 * (size_t)edges->count] = ends[0];
    edges->ends[2 * (size_t)edges->count + 1] = ends[1];
    for (size_t i = 0; i < count; i++)
        edges->of_side[sides[i]] = edges->count;
    edges->count++;
}

GpResult edges_find(const GpMesh *mesh, Edges *edges)
{
    const size_t side_count = 3 * (size_t)mesh->triangle_count;
    Edges found = { .of_side = gp_alloc_unset(side_count * sizeof(uint32_t) + 1),
                    .ends = gp_alloc_unset(2 * side_count * sizeof(uint32_t) + 1) };
    GpResult result = GP_ERROR_MEMORY;
    if (found.of_side && found.ends)
        result = edges_visit(mesh, mesh->indices, number_edge, &found);
    if (result == GP_OK)
        *edges = found;
    else
        edges_free(&found);
    return result;
}

void edges_free(Edges *edges)
{
    gp_free(edges->of_side);
    gp_free(edges->ends);
    *edges = (Edges){ .count = 0 };
}
