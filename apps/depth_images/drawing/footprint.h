/* How coarse a depth image may be for a view. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_FOOTPRINT_H
#define APPS_DEPTH_IMAGES_DRAWING_FOOTPRINT_H

#include "apps/depth_images/drawing/view.h"

enum { FOOTPRINT_MAX_STEP = 128 };

/* The root of how many pixels of an image fall on one of the picture where the image is nearest, as
 * the nearest power of two; 1 when near.
 * in     center, radius: of a ball about the image; pixel: side of its pixels in the world
 * source paper 001, section 3.5: Iter_step */
uint32_t footprint_step(const double center[3], double radius, double pixel, const WarpView *view);

#endif
