/* Convex pieces, front to back: all fragments in one reading of the mesh.
 *
 * A level of the order (order/order.h) is drawn at once: its near faces into one target, its far
 * faces into another, both by MAX onto 0; then both go under what is there, where the level has
 * anything. Each face is drawn once. Faces in knots have a pass of their own, in which the machine
 * sorts.
 *
 * source paper 002, section 4
 * DEVIATES: the paper draws piece after piece; here all pieces of a level are, which share no
 *        pixel. Knots are sorted by the machine (GP_ORDER_DEPTH_NEAR_FIRST), however many layers
 *        they have. Slabs of orders by a grid are sorted by the stencil-routed k-buffer as printed,
 *        but its 4 layers are surfaces, drawn one by one, since the machine's pixels have no
 *        samples. For translucency it keeps depths in the targets, and here what follows from
 *        them. */
#ifndef APPS_FRAGMENTS_CONVEX_CONVEX_H
#define APPS_FRAGMENTS_CONVEX_CONVEX_H

#include "apps/fragments/order/parting.h"

/* A mesh in pieces, for all views. A zeroed one is empty. */
typedef struct ConvexModel {
    const FragmentMesh *mesh; /* borrowed */
    Pieces *pieces;
    OrderMesh order;
    Partings *partings; /* of orders by a grid; NULL: there are none */
} ConvexModel;

typedef enum ConvexOrder {
    CONVEX_ORDER_EXACT, /* order/order.h */
    CONVEX_ORDER_GRID   /* order/grid.h: as printed, and sometimes wrong */
} ConvexOrder;

/* How a model is made. All zero: exact pieces, for any exact order, not kept. */
typedef struct ConvexSetting {
    PiecesSetting pieces;
    bool has_partings; /* for orders by a grid too */
    /* a file that is read where it is of this mesh and setting, and else written */
    const char *cache;
    PiecesProgress progress; /* NULL: nobody asks */
    void *context;
} ConvexSetting;

/* Makes a mesh's pieces, and what parts them, or reads them.
 * out    fault: why the cache was of no use, or could not be written; empty: it was not, or there
 *        was none
 * errors those of pieces_make and partings_make; owns: the caller, until convex_close */
GpResult convex_open(const FragmentMesh *mesh, const ConvexSetting *setting, ConvexModel *model,
                     GpError *fault, GpError *error);
void convex_close(ConvexModel *model); /* a zeroed one is fine */

/* What is to be said of a view. */
typedef struct ConvexFacts {
    uint32_t pieces, levels;
    uint32_t sides; /* of pieces that are seen */
    /* those that were taken apart into faces; of a grid, circles that were cut */
    uint32_t split_sides;
    uint32_t knots, knot_faces; /* of a grid, slabs */
} ConvexFacts;

/* As view.h has it.
 * in     order: by a grid of models with partings only
 * out    facts: may be NULL
 * errors GP_ERROR_MEMORY */
GpResult convex_add(const ConvexModel *model, ConvexOrder order, const FragmentView *view,
                    GpSurface *color, GpSurface *depth, Frame *frame, ConvexFacts *facts,
                    GpError *error);

#endif
