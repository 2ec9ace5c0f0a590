/* Planar depth images before a view: matrices, and where they are. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_PLANE_H
#define APPS_DEPTH_IMAGES_DRAWING_PLANE_H

#include "apps/depth_images/drawing/view.h"

/* World of a place (s x, s y, depth, 1): x and y in pixels of the picture, s = depth where rays meet in
 * an eye, and 1 where they are parallel. out matrix: its last row is 0 0 0 1 */
void plane_to_world(const DepthPlane *plane, const DepthPixels *pixels, double matrix[4][4]);

/* World to clip of a view. */
void view_to_clip(const WarpView *view, double matrix[4][4]);

/* The least and the greatest depth of a layer; false: it shows nothing. */
bool depth_range(const DepthPixels *pixels, double range[2]);

/* A ball about all that an image shows; radius 0: nothing. */
void plane_ball(const DepthImage *image, double center[3], double *radius);

#endif
