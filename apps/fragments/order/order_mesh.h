/* A mesh in convex pieces, with what its order from any view is found by. Made once. */
#ifndef APPS_FRAGMENTS_ORDER_ORDER_MESH_H
#define APPS_FRAGMENTS_ORDER_ORDER_MESH_H

#include "apps/fragments/drawing/view.h"
#include "apps/fragments/pieces/pieces.h"

enum {
    ORDER_AXES = 7,   /* along which pieces are measured: x, y, z and the diagonals */
    ORDER_LARGE = 256 /* faces from which on pieces are compared as a whole, where that tells */
};

extern const double order_axes[ORDER_AXES][3];

/* Ends of a piece along the axes. */
typedef struct PieceSpan {
    double low[ORDER_AXES], high[ORDER_AXES];
} PieceSpan;

typedef struct OrderMesh {
    const FragmentMesh *mesh; /* borrowed */
    const Pieces *pieces;     /* borrowed */
    double (*planes)[4];      /* by face: normal, unit length or 0, and distance */
    PieceSpan *spans;         /* by piece */
    double doubt;             /* of distances: far more than their roundings */
} OrderMesh;

/* errors GP_ERROR_MEMORY */
GpResult order_mesh_make(const FragmentMesh *mesh, const Pieces *pieces, OrderMesh *made,
                         GpError *error);
void order_mesh_free(OrderMesh *mesh);

static inline bool order_is_large(const Pieces *pieces, uint32_t piece)
{
    return pieces->first[piece + 1] - pieces->first[piece] >= ORDER_LARGE;
}

#endif
