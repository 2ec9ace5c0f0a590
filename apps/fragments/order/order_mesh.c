#include "apps/fragments/order/order_mesh.h"

#include "apps/base/bounds.h"

#include <float.h>

const double order_axes[ORDER_AXES][3] = { { 1, 0, 0 },  { 0, 1, 0 },  { 0, 0, 1 }, { 1, 1, 1 },
                                           { -1, 1, 1 }, { 1, -1, 1 }, { 1, 1, -1 } };

static void find_plane(const FragmentMesh *mesh, uint32_t face, double plane[4])
{
    double corner[3][3], side[2][3];
    for (uint32_t c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            corner[c][k] = (double)mesh->positions[mesh->indices[3 * (size_t)face + c]][k];
    vector_subtract(corner[1], corner[0], side[0]);
    vector_subtract(corner[2], corner[0], side[1]);
    vector_cross(side[0], side[1], plane);
    vector_normalize(plane);
    plane[3] = vector_dot(plane, corner[0]);
}

static void measure_piece(const FragmentMesh *mesh, const Pieces *pieces, uint32_t piece,
                          PieceSpan *span)
{
    for (int a = 0; a < ORDER_AXES; a++) {
        span->low[a] = DBL_MAX;
        span->high[a] = -DBL_MAX;
    }
    for (uint32_t i = 3 * pieces->first[piece]; i < 3 * pieces->first[piece + 1]; i++) {
        const float *at = mesh->positions[mesh->indices[3 * (size_t)pieces->faces[i / 3] + i % 3]];
        for (int a = 0; a < ORDER_AXES; a++) {
            const double along = order_axes[a][0] * (double)at[0] +
                                 order_axes[a][1] * (double)at[1] +
                                 order_axes[a][2] * (double)at[2];
            span->low[a] = fmin(span->low[a], along);
            span->high[a] = fmax(span->high[a], along);
        }
    }
}

GpResult order_mesh_make(const FragmentMesh *mesh, const Pieces *pieces, OrderMesh *made,
                         GpError *error)
{
    const uint32_t faces = mesh->triangle_count;
    const Bounds bounds =
        bounds_of(&mesh->positions[0][0], 3 * sizeof(float), mesh->indices, 3 * faces);
    OrderMesh order = { .mesh = mesh,
                        .pieces = pieces,
                        .planes = gp_alloc(faces, sizeof *order.planes),
                        .spans = gp_alloc(pieces->count, sizeof *order.spans) };
    if (!order.planes || !order.spans) {
        order_mesh_free(&order);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    for (int k = 0; k < 3 && faces > 0; k++)
        order.doubt = fmax(order.doubt, 0x1p-44 * fmax(fabs(bounds.low[k]), fabs(bounds.high[k])));
    for (uint32_t f = 0; f < faces; f++)
        find_plane(mesh, f, order.planes[f]);
    for (uint32_t p = 0; p < pieces->count; p++)
        measure_piece(mesh, pieces, p, &order.spans[p]);
    *made = order;
    return GP_OK;
}

void order_mesh_free(OrderMesh *mesh)
{
    gp_free(mesh->planes);
    gp_free(mesh->spans);
    *mesh = (OrderMesh){ .mesh = NULL };
}
