#include "apps/techniques/volume/methods.h"

/* --- rays ------------------------------------------------------------------------------------- */

static GpResult classify_rays(VolumeModel *model, GpError *error)
{
    (void)error;
    raycast_classify(&model->rays, &model->transfer);
    return GP_OK;
}

static GpResult add_rays(VolumeModel *model, const VolumeOptions *options,
                         const VolumeTarget *target, Frame *frame, GpError *error)
{
    GpResult result = GP_OK;
    if (!model->rays.field) {
        result = raycast_open(&model->field, &model->rays, error);
        if (!result)
            result = classify_rays(model, error);
    }
    return result ? result
                  : raycast_add(&model->rays, &model->view, &options->rays, target, frame, error);
}

static double surface_bytes(const GpSurface *surface)
{
    return surface ? (double)surface->level[0].pitch * surface->height : 0;
}

static double bytes_of_rays(const VolumeModel *model, const VolumeOptions *options)
{
    (void)options;
    return (surface_bytes(model->rays.atlas.surface) + surface_bytes(model->rays.runs)) /
           (double)field_samples(&model->field);
}

static void close_rays(VolumeModel *model)
{
    raycast_close(&model->rays);
}

/* --- slices ----------------------------------------------------------------------------------- */

static GpResult classify_slices(VolumeModel *model, GpError *error)
{
    (void)error;
    slices_classify(&model->slices, &model->transfer);
    return GP_OK;
}

static GpResult add_slices(VolumeModel *model, const VolumeOptions *options,
                           const VolumeTarget *target, Frame *frame, GpError *error)
{
    GpResult result = GP_OK;
    if (!model->slices.field) {
        result = slices_open(&model->field, &model->slices, error);
        if (!result)
            result = classify_slices(model, error);
    }
    return result
               ? result
               : slices_add(&model->slices, &model->view, &options->slices, target, frame, error);
}

/* Slices across two axes are the samples themselves. */
static double bytes_of_slices(const VolumeModel *model, const VolumeOptions *options)
{
    (void)options;
    return model->slices.turned ? 2 : 1;
}

static void close_slices(VolumeModel *model)
{
    slices_close(&model->slices);
}

/* --- splats ----------------------------------------------------------------------------------- */

static GpResult add_splats(VolumeModel *model, const VolumeOptions *options,
                           const VolumeTarget *target, Frame *frame, GpError *error)
{
    GpResult result = GP_OK;
    if (!model->splats.field)
        result = volume_splats_make(&model->field, &model->transfer, &model->splats, error);
    return result ? result
                  : volume_splats_add(&model->splats, &model->view, &options->splats, target, frame,
                                      error);
}

static GpResult classify_splats(VolumeModel *model, GpError *error)
{
    return volume_splats_classify(&model->splats, &model->transfer, error);
}

static double bytes_of_splat(const VolumeModel *model, const VolumeOptions *options)
{
    return volume_splats_bytes(&model->splats, options->splats.mode);
}

static uint64_t count_splats(const VolumeModel *model)
{
    return volume_splats_count(&model->splats);
}

static bool have_kernels(const VolumeOptions *options)
{
    return !options->splats.after;
}

static void close_splats(VolumeModel *model)
{
    volume_splats_free(&model->splats);
}

const VolumeMethodRow volume_methods[VOLUME_METHODS] = {
    [VOLUME_RAYCAST] = { add_rays, classify_rays, bytes_of_rays, NULL, NULL, close_rays },
    [VOLUME_SLICES] = { add_slices, classify_slices, bytes_of_slices, NULL, NULL, close_slices },
    [VOLUME_SPLAT] = { add_splats, classify_splats, bytes_of_splat, count_splats, have_kernels,
                       close_splats },
};
