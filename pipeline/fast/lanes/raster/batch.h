/* GP_LANES triangles of one draw, set up side by side. */
#ifndef GP_FAST_BATCH_H
#define GP_FAST_BATCH_H

#include "pipeline/fast/lanes/raster/corners.h"
#include "pipeline/fast/lanes/raster/fragment_path.h"

/* Vectors that are then taken apart by lanes. Places are in the tile; edges are those at (x, y). */
typedef struct TriangleBatch {
    const uint32_t *primitives;
    unsigned tiny, small, alone; /* bits: how each lane is to be filled, if at all */
    unsigned front;
    itg x, y;              /* first pixel of the box; even, where whole quads are wanted */
    itg width, height;     /* from there to the last: one less than the number of pixels */
    itg covered;           /* pixels of a tiny triangle's 4x4 box, a bit each, by rows */
    itg edge[3];           /* exact */
    itg inside[3];         /* in 256ths, negative outside */
    itg right[3], down[3]; /* steps of `inside`, a pixel further */
    itg steps[3];          /* both, in the low and the high half */
    dbl base, step[2];     /* of depth */
    flt nearest;           /* no pixel's depth is below */

    /* for shading: the corner that is nearest to the eye, and of the two after it, edges and ratios
     * as in a record */
    itg area2, shade_first;
    itg shade_edge[2], shade_steps[2];
    flt ratio[2];
} TriangleBatch;

/* Sets up triangles of the present draw. */
void fast_set_up_batch(const Filler *filler, const BatchCorners *corners, TriangleBatch *batch);

/* What shading needs of a lane's triangle. */
void fast_write_record(const FastDraw *draw, const TriangleBatch *batch, uint32_t lane,
                       FastTriangleRecord *record);

#endif
