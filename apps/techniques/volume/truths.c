#include "apps/techniques/volume/truths.h"

#include "apps/truth/volume_kernels.h"
#include "apps/truth/volume_rays.h"

#include <math.h>
#include <string.h>

/* stops: of the transfer function, for the truth's own use */
static VolumeScene scene_of(const VolumeSource *source, const VolumeView *view,
                            VolumeStop stops[TRANSFER_MAX_STOPS])
{
    const Field *field = source->field;
    const Transfer *transfer = source->transfer;
    for (uint32_t i = 0; i < transfer->count; i++) {
        stops[i].value = transfer->stops[i].value;
        memcpy(stops[i].rgba, transfer->stops[i].rgba, sizeof stops[i].rgba);
    }
    VolumeScene scene = { .value = field->value,
                          .stops = stops,
                          .stop_count = transfer->count,
                          .camera = view->camera,
                          .width = view->width,
                          .height = view->height };
    memcpy(scene.size, field->size, sizeof scene.size);
    memcpy(scene.scale, field->scale, sizeof scene.scale);
    return scene;
}

GpResult volume_truth_of_data(const VolumeSource *source, const VolumeView *view, int threads,
                              VolumePicture *truth, GpError *error)
{
    VolumeStop stops[TRANSFER_MAX_STOPS];
    const VolumeScene scene = scene_of(source, view, stops);
    GpPool *pool;
    GpResult result = gp_pool_create(threads, &pool, error);
    if (result)
        return result;
    result = volume_rays_picture(&scene, 1, pool, truth);
    gp_pool_destroy(&pool);
    return result ? gp_fail(error, result, "no memory for the truth") : GP_OK;
}

/* So many a side of a pixel that neither the filter nor a kernel falls between two: the least of
 * both is to be 0.8 of their distance wide. */
static uint32_t rays_of(const VolumeSource *source, const VolumeView *view,
                        const VolumeKernel *kernel)
{
    const Camera *camera = &view->camera;
    const CameraAxes axes = camera_axes(camera, (double)view->width / view->height);
    double middle[3], distance = 1;
    for (int k = 0; k < 3; k++)
        middle[k] = (source->field->size[k] - 1) * source->field->scale[k] / 2 - camera->eye[k];
    if (camera->fovy > 0)
        distance = fmax(vector_dot(middle, axes.forward), camera->near);
    const double pixels = view->height / (2 * axes.half_height * distance) * kernel->deviation;
    return (uint32_t)fmin(fmax(ceil(0.8 / fmin(pixels, kernel->low_pass)), 2), 4);
}

GpResult volume_truth_of_kernels(const VolumeSource *source, const VolumeView *view,
                                 const VolumeKernel *kernel, int threads, VolumePicture *truth,
                                 GpError *error)
{
    VolumeStop stops[TRANSFER_MAX_STOPS];
    const VolumeScene scene = scene_of(source, view, stops);
    const VolumeKernels kernels = { .deviation = kernel->deviation,
                                    .cut = kernel->cut,
                                    .low_pass = kernel->low_pass,
                                    .rays = rays_of(source, view, kernel) };
    GpPool *pool;
    GpResult result = gp_pool_create(threads, &pool, error);
    if (result)
        return result;
    result = volume_kernels_picture(&scene, &kernels, pool, truth);
    gp_pool_destroy(&pool);
    return result ? gp_fail(error, result, "no memory for the truth") : GP_OK;
}

/* --- errors ----------------------------------------------------------------------------------- */

/* How far a pixel of A8R8G8B8 is above the truth: red, green, blue. */
static void pixel_off(const VolumePicture *truth, size_t at, const GpSurface *picture,
                      double off[3])
{
    const uint8_t *texel = picture->level[0].texels + 4 * at;
    for (int k = 0; k < 3; k++)
        off[k] = texel[2 - k] / 255.0 - truth->rgba[4 * at + (size_t)k];
}

double volume_rmse(const VolumePicture *truth, const GpSurface *picture)
{
    const size_t pixels = (size_t)truth->width * truth->height;
    double square = 0, off[3];
    for (size_t at = 0; at < pixels; at++) {
        pixel_off(truth, at, picture, off);
        square += vector_dot(off, off);
    }
    return sqrt(square / (3 * (double)pixels));
}

double volume_psnr(double rmse)
{
    return -20 * log10(fmax(rmse, 1e-10));
}

void volume_difference(const VolumePicture *truth, const GpSurface *picture, float *off)
{
    for (size_t at = 0; at < (size_t)truth->width * truth->height; at++) {
        double each[3];
        pixel_off(truth, at, picture, each);
        off[at] = (float)((each[0] + each[1] + each[2]) / 3);
    }
}
