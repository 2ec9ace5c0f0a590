#include "apps/points/edges.h"

#include <stdlib.h>

/* A side of a triangle, listed at its lower vertex. */
typedef struct Side {
    uint32_t high, side;
} Side;

static int compare_sides(const void *a, const void *b)
{
    const Side *x = a, *y = b;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return x->side < y->side ? -1 : x->side > y->side;
}

/* A vertex has few sides mostly, for which insertion is fastest; the hub of a large fan has not. */
static void sort_sides(Side *sides, size_t count)
{
    if (count > 32) {
        qsort(sides, count, sizeof *sides, compare_sides);
        return;
    }
    for (size_t i = 1; i < count; i++) {
        const Side side = sides[i];
        size_t at = i;
        for (; at > 0 && compare_sides(&side, &sides[at - 1]) < 0; at--)
            sides[at] = sides[at - 1];
        sides[at] = side;
    }
}

static void side_ends(const GpMesh *mesh, size_t side, uint32_t *low, uint32_t *high)
{
    const size_t triangle = side / 3, corner = side % 3;
    const uint32_t a = mesh->indices[side];
    const uint32_t b = mesh->indices[3 * triangle + (corner + 1) % 3];
    *low = a < b ? a : b;
    *high = a < b ? b : a;
}

/* Lists the sides by lower vertex: those of v are sides[first[v]] .. sides[first[v + 1] - 1]. */
static void list_sides(const GpMesh *mesh, size_t side_count, size_t *first, Side *sides)
{
    uint32_t low, high;
    for (size_t s = 0; s < side_count; s++) {
        side_ends(mesh, s, &low, &high);
        first[low + 2]++;
    }
    for (size_t v = 2; v < (size_t)mesh->vertex_count + 2; v++)
        first[v] += first[v - 1];
    for (size_t s = 0; s < side_count; s++) {
        side_ends(mesh, s, &low, &high);
        sides[first[low + 1]++] = (Side){ .high = high, .side = (uint32_t)s };
    }
}

GpResult edges_find(const GpMesh *mesh, Edges *edges)
{
    const size_t side_count = 3 * (size_t)mesh->triangle_count;
    size_t *first = gp_alloc((size_t)mesh->vertex_count + 2, sizeof *first);
    Side *sides = gp_alloc_unset(side_count * sizeof *sides + 1);
    Edges found = { .of_side = gp_alloc_unset(side_count * sizeof(uint32_t) + 1),
                    .ends = gp_alloc_unset(2 * side_count * sizeof(uint32_t) + 1) };
    const bool has_room = first && sides && found.of_side && found.ends;
    if (has_room)
        list_sides(mesh, side_count, first, sides);
    for (uint32_t v = 0; has_room && v < mesh->vertex_count; v++) {
        const size_t count = first[v + 1] - first[v];
        Side *own = sides + first[v];
        sort_sides(own, count);
        for (size_t i = 0; i < count; i++) {
            if (i == 0 || own[i].high != own[i - 1].high) {
                found.ends[2 * (size_t)found.count] = v;
                found.ends[2 * (size_t)found.count + 1] = own[i].high;
                found.count++;
            }
            found.of_side[own[i].side] = found.count - 1;
        }
    }
    gp_free(first);
    gp_free(sides);
    if (has_room)
        *edges = found;
    else
        edges_free(&found);
    return has_room ? GP_OK : GP_ERROR_MEMORY;
}

void edges_free(Edges *edges)
{
    gp_free(edges->of_side);
    gp_free(edges->ends);
    *edges = (Edges){ .count = 0 };
}
