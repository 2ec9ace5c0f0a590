/* Planar depth images as triangles in their own pictures: cells merged where they are flat
 * (merge.h), and cells through which a surface ends, as far as half a cell from its last pixels,
 * with the slope that the surface has there and colours of no other surface.
 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_GRID_H
#define APPS_DEPTH_IMAGES_DRAWING_GRID_H

#include "apps/depth_images/drawing/edges.h"

/* How a surface goes on beyond its last vertices. All zero: as it came there. */
typedef struct GridEnds {
    double lean; /* times as steep, since surfaces curve away where they end; 0: 1 */
    /* by so many pixel widths its depth may change in half a step: from the side longer ends are
     * streaks; 0: by any */
    double most;
} GridEnds;

/* All zero: every pixel is a vertex, and flat places are merged. */
typedef struct GridSetting {
    uint32_t step; /* pixels from vertex to vertex; 0: 1 */
    /* by which depths may be off, in pixels that they are seen aside by an eye as far from the
     * image's as the nearest point is; of parallel images in widths of pixels. 0: GRID_TOLERANCE;
     * below 0: nothing is merged */
    double tolerance;
    /* of a surface beyond its last vertices, of the way to the next, at most 0.5, where its end is
     * on the average; 0: 0.5 */
    double reach;
    GridEnds ends;
    /* counter-clockwise seen from outside, as normals say, instead of from the image's eye */
    bool turned;
} GridSetting;

#define GRID_TOLERANCE 1.0

typedef struct GridVertex {
    float x, y,
        depth;  /* of the picture, in pixels from its upper left corner; as the image has it */
    float u, v; /* where its colour is, 0..1: another place than its own where a surface ends */
} GridVertex;

/* Triangles, counter-clockwise in the image's own picture but for `turned`. A zeroed one is
 * empty. */
typedef struct WarpGrid {
    GridVertex *vertices;
    uint32_t *indices;
    uint32_t vertex_count, index_count;
} WarpGrid;

/* in pixels: of step 1; errors GP_ERROR_MEMORY; owns: the caller, until warp_grid_free */
GpResult warp_grid_make(const DepthLattice *pixels, const GridSetting *setting, WarpGrid *grid);
void warp_grid_free(WarpGrid *grid); /* a zeroed one is fine */

#endif
