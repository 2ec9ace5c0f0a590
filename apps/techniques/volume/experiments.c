#include "apps/techniques/volume/experiments.h"

#include "apps/techniques/volume/methods.h"
#include "apps/techniques/volume/words.h"

static const TechniqueSweep sweep[] = {
    { "rays", "--method raycast --step 0.5|1|1.5|2|3" },
    { "planes", "--method slices --spacing 0.5|1|2" },
    { "splats", "--method splat --thickness 1|2" },
    { "splats, wider", "--method splat --deviation 0.6|0.7" },
    { "slabs", "--method splat --sheets image --thickness 1|2" },
    { "classified after", "--method splat --after --thickness 1|2" },
    { "flat", "--method splat --flat" },
    { "sums of floats", "--method splat --accumulate 32f" },
    { "reconstruction alone", "--method splat --filter reconstruction" },
    { "low-pass alone", "--method splat --filter lowpass" },
    { "as printed", "--method splat --alphas --thickness 1" },
    { .method = NULL },
};

static const char *const usual[] = { "rays", "planes", "splats", NULL };
static const char *const metrics[] = { "decibels", "bytes", NULL };

static GpResult find_truth(void *model, int threads, GpError *error)
{
    return volume_model_data(model, threads, error);
}

static GpResult measure(void *made, const Frame *frame, TechniqueError *measured, GpError *error)
{
    const VolumeModel *model = made;
    const VolumeOptions *options = frame->made;
    (void)error;
    const double off = volume_rmse(&model->data, frame->color);
    const double bytes = volume_methods[options->method].bytes_per_voxel(model, options);
    *measured = (TechniqueError){ .error = 255 * off,
                                  .metrics = { volume_psnr(off), bytes },
                                  .whole = 255 };
    return GP_OK;
}

static GpResult find_difference(void *made, const void *setting, GpDevice *device, Frame *frame,
                                float *off, GpError *error)
{
    const VolumeModel *model = made;
    (void)setting, (void)device, (void)error;
    volume_difference(&model->data, frame->color, off);
    return GP_OK;
}

const Experiment volume_experiments[] = {
    { .name = "volume",
      .title = "Volumes: time against error",
      .scene = "builtin:marschner-lobb:128",
      .sweep = sweep,
      .usual = usual,
      .error_name = "codes",
      .part_of = "the whole range of a colour",
      .metrics = metrics,
      .words = volume_words,
      .truth = volume_truth_words,
      .difference = find_difference,
      .over = "brighter than in truth",
      .under = "darker",
      .find_truth = find_truth,
      .measure = measure },
    { .name = NULL },
};
