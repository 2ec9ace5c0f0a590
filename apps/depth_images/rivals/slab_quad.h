/* Rectangles in the box of a depth image, and eyes as they are seen from there. */
#ifndef APPS_DEPTH_IMAGES_RIVALS_SLAB_QUAD_H
#define APPS_DEPTH_IMAGES_RIVALS_SLAB_QUAD_H

#include "apps/depth_images/rivals/slab.h"

/* A rectangle parallel to the picture, as programs of shaders_c/warp/slab_quad_shared.h take it.
 * in     z, first, side: of the box, beyond which the rectangle may reach
 *        frame: owns the corners
 * returns false: there is no memory, of which the frame knows */
bool slab_quad(const DepthSlab *slab, double z, const double first[2], const double side[2],
               Frame *frame, GpGeometry *quad);

/* A camera's eye in the box, homogeneous; of parallel views the direction towards it. */
void slab_eye(const DepthSlab *slab, const Camera *camera, double eye[4]);

/* Lengths of the box's sides in the world: of perspective images, whose box is wider at its end,
 * the mean. */
void slab_metric(const DepthSlab *slab, double metric[3]);

#endif
