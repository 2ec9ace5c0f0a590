/* Planar depth images as cells between four pixels each, as shaders_c/warp/cells.h has them. */
#ifndef APPS_DEPTH_IMAGES_RIVALS_CELLS_H
#define APPS_DEPTH_IMAGES_RIVALS_CELLS_H

#include "apps/depth_images/rivals/slab.h"
#include "shaders_c/warp/cells.h"

/* The cells that a box is on. A zeroed one is empty. Owned by whoever made it, until
 * depth_cells_close. */
typedef struct DepthCells {
    float first[2], side[2]; /* of the box, in texels */
    GpSurface *z;
} DepthCells;

/* errors GP_ERROR_MEMORY; GP_ERROR_INVALID: larger than textures may be */
GpResult depth_cells_open(const DepthSlab *slab, const DepthPixels *pixels, DepthCells *cells,
                          GpError *error);
void depth_cells_close(DepthCells *cells);

/* in     thickness: of the surface, as a share of the depths of the image: how far behind its edges
 *        rays still meet it; 0: 0.1; below 0: all the way, as walls that hang to the farthest
 *        depth */
CellUniforms depth_cells_uniforms(const DepthCells *cells, double thickness);

/* Sets slot 0 of a draw. */
void depth_cells_texture(const DepthCells *cells, GpDraw *draw);

#endif
