/* What a camera's pixels and depths stand for, in double. */
#ifndef TESTS_VIEW_RAYS_H
#define TESTS_VIEW_RAYS_H

#include "apps/base/camera.h"

/* The ray through a place of a picture, in pixels from the left and from the top; multiples of its
 * direction are distances along the view. */
static inline void view_ray(const Camera *camera, double x, double y, int width, int height,
                            double from[3], double direction[3])
{
    const CameraAxes axes = camera_axes(camera, (double)width / height);
    for (int k = 0; k < 3; k++) {
        const double aside = axes.right[k] * (2 * x / width - 1) * axes.half_width +
                             axes.up[k] * (1 - 2 * y / height) * axes.half_height;
        const bool meets = camera->fovy > 0;
        from[k] = camera->eye[k] + (meets ? 0 : aside);
        direction[k] = axes.forward[k] + (meets ? aside : 0);
    }
}

/* The distance along the view of a depth, 0 to 1. */
static inline double view_distance(const Camera *camera, double z)
{
    const double near = camera->near, far = camera->far;
    return camera->fovy > 0 ? near * far / (far - z * (far - near)) : near + z * (far - near);
}

#endif
