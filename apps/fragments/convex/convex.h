/* Convex pieces, front to back: all fragments in one reading of the mesh.
 *
 * A level of the order (order/order.h) is drawn at once: its near faces into one target, its far faces into
 * another, both by MAX onto 0; then both go under what is there, where the level has anything. Each face is
 * drawn once. Faces in knots have a pass of their own, in which the machine sorts.
 *
 * source paper 002, section 4
 * DEVIATES: the paper draws piece after piece; here all pieces of a level are, which share no pixel. It
 *        sorts the faces between neighbours by the stencil-routed k-buffer, 4 layers of 8 samples, which the
 *        machine does not have; knots are sorted by the machine (GP_ORDER_DEPTH_NEAR_FIRST), however many
 *        layers they have. For translucency it keeps depths in the targets, and here what follows from them. */
#ifndef APPS_FRAGMENTS_CONVEX_CONVEX_H
#define APPS_FRAGMENTS_CONVEX_CONVEX_H

#include "apps/fragments/order/order_mesh.h"

/* A mesh in pieces, for all views. A zeroed one is empty. */
typedef struct ConvexModel {
    const FragmentMesh *mesh; /* borrowed */
    Pieces *pieces;
    OrderMesh order;
} ConvexModel;

/* Makes a mesh's pieces, or reads them.
 * in     cache: a file, which is read where it is of this mesh and setting, and else written; NULL: none
 * out    fault: why the cache was of no use, or could not be written; empty: it was not, or there was none
 * errors those of pieces_make; owns: the caller, until convex_close */
GpResult convex_open(const FragmentMesh *mesh, const PiecesSetting *setting, const char *cache,
                     ConvexModel *model, GpError *fault, GpError *error);
void convex_close(ConvexModel *model); /* a zeroed one is fine */

typedef enum ConvexOrder {
    CONVEX_ORDER_EXACT, /* order/order.h */
    CONVEX_ORDER_GRID   /* order/grid.h: as printed, and sometimes wrong */
} ConvexOrder;

/* What is to be said of a view. */
typedef struct ConvexFacts {
    uint32_t pieces, levels;
    uint32_t sides; /* of pieces that are seen */
    uint32_t
        split_sides; /* those that were taken apart into faces; of a grid, circles that were cut */
    uint32_t knots, knot_faces;
} ConvexFacts;

/* As view.h has it.
 * out    facts: may be NULL
 * errors GP_ERROR_MEMORY */
GpResult convex_add(const ConvexModel *model, ConvexOrder order, const FragmentView *view,
                    GpSurface *color, GpSurface *depth, Frame *frame, ConvexFacts *facts,
                    GpError *error);

#endif
