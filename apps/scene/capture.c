#include "apps/scene/capture.h"

#include "apps/depth_images/capture.h"
#include "apps/depth_images/drawing/surface_grid.h"

/* The depth along the view that a depth buffer's value means (camera_projection). */
static double depth_of(const Camera *camera, double value)
{
    const double near = camera->near, far = camera->far;
    return camera->fovy > 0 ? near * far / (far - value * (far - near))
                            : near + value * (far - near);
}

static void take_pixels(const Camera *camera, const float *color, const float *depth,
                        DepthPixels *pixels)
{
    for (size_t i = 0; i < (size_t)pixels->width * pixels->height; i++) {
        if (depth[4 * i] < 1)
            pixels->depth[i] = (float)depth_of(camera, (double)depth[4 * i]);
        for (size_t k = 0; k < 3; k++) {
            const float c = color[4 * i + k];
            pixels->color[3 * i + k] = c > 0 ? c < 1 ? c : 1 : 0; /* NaN: 0 */
        }
    }
}

static GpResult take_image(const Scene *scene, DepthImage *image, GpError *error)
{
    const GpSurface *picture = scene->picture;
    const size_t texels = (size_t)picture->width * picture->height;
    float *color = gp_alloc(texels, 4 * sizeof *color),
          *depth = gp_alloc(texels, 4 * sizeof *depth);
    GpResult result = color && depth
                          ? depth_pixels_make(picture->width, picture->height, false, &image->front)
                          : GP_ERROR_MEMORY;
    if (result)
        gp_fail(error, result, "no memory for %ux%u pixels", picture->width, picture->height);
    if (!result)
        result = gp_surface_read_floats(picture, 0, NULL, color, error);
    if (!result)
        result = gp_surface_read_floats(scene->depth, 0, NULL, depth, error);
    if (!result)
        take_pixels(&scene->camera, color, depth, &image->front);
    gp_free(color);
    gp_free(depth);
    return result ? result : surface_grid_normals(image, 4, &image->front.normal, error);
}

GpResult scene_capture(GpDevice *device, const Scene *scene, DepthImage *image, GpError *error)
{
    if (scene->has_passes)
        return gp_fail(
            error, GP_ERROR_INVALID,
            "a scene with passes of its own, which may look from elsewhere: expected objects "
            "and lights under one camera, without \"passes\"");
    if (!scene->depth)
        return gp_fail(error, GP_ERROR_INVALID, "a scene without a depth buffer");
    const double aspect = (double)scene->picture->width / scene->picture->height;
    DepthImage made = { .plane = depth_plane_of_camera(&scene->camera, aspect) };
    GpResult result = gp_device_run(device, &scene->list, error);
    if (!result)
        result = take_image(scene, &made, error);
    if (result)
        depth_pixels_free(&made.front);
    else
        *image = made;
    return result;
}
