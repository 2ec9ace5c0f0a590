#include "apps/depth_images/drawing/footprint.h"

static const double between_steps = 1.4142135623730951; /* powers of two: the nearer by ratio */

uint32_t footprint_step(const double center[3], double radius, double pixel, const WarpView *view)
{
    const Camera *camera = &view->camera;
    const CameraAxes axes = camera_axes(camera, (double)view->width / view->height);
    double way[3], away = 1;
    uint32_t step = 1;
    vector_subtract(center, camera->eye, way);
    if (camera->fovy > 0)
        away = fmax(vector_dot(way, axes.forward) - radius, camera->near);
    const double wanted = 2 * axes.half_height * away / view->height / pixel;
    while (between_steps * step <= wanted && step < FOOTPRINT_MAX_STEP)
        step *= 2;
    return step;
}
