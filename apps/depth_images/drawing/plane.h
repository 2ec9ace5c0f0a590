/* Planar depth images before a view: matrices, and where they are. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_PLANE_H
#define APPS_DEPTH_IMAGES_DRAWING_PLANE_H

#include "apps/depth_images/drawing/view.h"

/* World of a place (s x, s y, depth, 1): x and y in pixels of the picture, s = depth where rays
 * meet in an eye, and 1 where they are parallel. out matrix: its last row is 0 0 0 1 */
void plane_to_world(const DepthPlane *plane, const DepthPixels *pixels, double matrix[4][4]);

/* World to clip of a view. */
void view_to_clip(const WarpView *view, double matrix[4][4]);

/* What of a layer shows something: x and y in pixels from its upper left corner, and depth. */
typedef struct DepthExtent {
    double low[3], high[3];
} DepthExtent;

/* returns false: it shows nothing, low is above high */
bool depth_extent(const DepthPixels *pixels, DepthExtent *extent);

/* A view's eye in the axes of an image (right, up, forward): x, y, z, 1; where its rays are
 * parallel, the direction that they come from, and 0. */
void plane_eye(const DepthPlane *plane, const WarpView *view, double eye[4]);

/* Says that a view looks at an image from behind, a sentence; NULL: it does not. */
const char *plane_warning(const DepthPlane *plane, const DepthExtent *extent, const WarpView *view);

/* Half the step of footprint.h, at least 1: cells that are merged cost little, and levels of
 * textures too early blur. in: as footprint_step */
uint32_t plane_step(const double center[3], double radius, double pixel, const WarpView *view);

/* A ball about all that an image shows; radius 0: nothing. */
void plane_ball(const DepthImage *image, double center[3], double *radius);

#endif
