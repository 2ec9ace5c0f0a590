#include "apps/points/sides.h"

#include "apps/base/vector.h"
#include "apps/points/cloud/distinct.h"

/* --- welding ---------------------------------------------------------------------------------- */

static bool are_apart(const uint32_t *first, uint32_t count)
{
    for (uint32_t v = 0; v < count; v++)
        if (first[v] != v)
            return false;
    return true;
}

GpResult corners_weld(const GpMesh *mesh, uint32_t **welded)
{
    const size_t corners = 3 * (size_t)mesh->triangle_count;
    uint32_t *first = gp_alloc_unset(mesh->vertex_count * sizeof *first + 1), *made = NULL;
    GpResult result = GP_ERROR_MEMORY;
    if (first)
        result = places_find(mesh->positions, mesh->vertex_count, first);
    if (result == GP_OK && !are_apart(first, mesh->vertex_count)) {
        made = gp_alloc_unset(corners * sizeof *made + 1);
        result = made ? GP_OK : GP_ERROR_MEMORY;
        for (size_t i = 0; made && i < corners; i++)
            made[i] = first[mesh->indices[i]];
    }
    gp_free(first);
    if (result == GP_OK)
        *welded = made;
    return result;
}

/* --- sides ------------------------------------------------------------------------------------ */

/* context: mate */
static void pair_sides(void *context, const uint32_t ends[2], const uint32_t *sides, size_t count)
{
    (void)ends;
    uint32_t *mate = context;
    for (size_t i = 0; i < count; i++)
        mate[sides[i]] = count == 2 ? sides[1 - i] : NO_SIDE;
}

GpResult sides_find(const GpMesh *mesh, Sides *sides)
{
    Sides found = { .mate =
                        gp_alloc_unset(3 * (size_t)mesh->triangle_count * sizeof(uint32_t) + 1) };
    GpResult result = found.mate ? corners_weld(mesh, &found.welded) : GP_ERROR_MEMORY;
    found.corners = found.welded ? found.welded : mesh->indices;
    if (result == GP_OK)
        result = edges_visit(mesh, found.corners, pair_sides, found.mate);
    if (result == GP_OK)
        *sides = found;
    else
        sides_free(&found);
    return result;
}

void sides_free(Sides *sides)
{
    gp_free(sides->mate);
    gp_free(sides->welded);
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
