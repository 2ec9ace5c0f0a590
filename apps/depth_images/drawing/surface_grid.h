/* Points of depth images in the world, as a grid with steps: what surfaces are merged from. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_SURFACE_GRID_H
#define APPS_DEPTH_IMAGES_DRAWING_SURFACE_GRID_H

#include "apps/depth_images/depth_image.h"

/* Every step'th column and row, the last row too; of a cylinder behind the last column the first
 * again. Owned by whoever made it, until surface_grid_close. */
typedef struct SurfaceGrid {
    const DepthImage *image; /* borrowed */
    uint32_t step, columns, rows;
    bool has_normals;
    float (*position)[3]; /* [rows][columns]; x infinite: nothing is shown */
    float (*normal)[3];   /* likewise */
    uint8_t *cut;         /* [rows][columns]: as of merge.h */
} SurfaceGrid;

/* in     normals: [height][width][3] of the image; NULL: there are none, and they are 0 cut:
 *        neighbours whose depths differ by more than so many times their distance are one surface
 *        only where that is no jump, three times as steep as on either side, and where the way from
 *        one to the other goes along the surface at both ends, as far as normals tell. Below 0: all
 *        are
 * errors GP_ERROR_MEMORY */
GpResult surface_grid_open(const DepthImage *image, const float *normals, uint32_t step, double cut,
                           SurfaceGrid *grid, GpError *error);
void surface_grid_close(SurfaceGrid *grid);

/* Where a point of the grid is on the image's textures. */
void surface_grid_texcoord(const SurfaceGrid *grid, uint32_t point, float texcoord[2]);

/* Side of a pixel in the world, the root of its area, about: at a cylinder's wall; half way into a
 * perspective image. */
double surface_grid_pixel(const DepthImage *image);

/* Normals from points beside each other.
 * out    normals: [height][width][3], owned by the caller until gp_free
 * errors GP_ERROR_MEMORY */
GpResult surface_grid_normals(const DepthImage *image, double cut, float **normals, GpError *error);

#endif
