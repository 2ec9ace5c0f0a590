#include "apps/techniques/warp/experiments.h"

#include "apps/base/machine.h"
#include "apps/techniques/warp/model.h"
#include "apps/techniques/warp/words.h"

static const TechniqueSweep sweep[] = {
    { "layers", "--method layers --tolerance 0.25|0.5|1|2" },
    { "layers, coarser", "--method layers --step 2|4" },
    { "front alone", "--method direct" },
    { "front, cut at 2 %", "--method direct --cut relative" },
    { "front, not cut", "--method direct --cut none" },
    { "as printed", "--method planar" },
    { "as printed, cut", "--method planar --cut slopes" },
    { "as a surface", "--method surface" },
    { "depth mesh", "--method dmesh" },
    { "depth mesh, simplified", "--method simplified" },
    { "cylinder, as a surface", "--kind cylinder --method surface" },
    { "cylinder, as printed", "--kind cylinder --method cylinder" },
    { "relief", "--method relief --search 16|32|64 --halvings 8" },
    { "displacement", "--method displacement --search 16|32|64" },
    { "relief texture", "--method relief-texture" },
    { "relief texture, not cut", "--method relief-texture --cut none" },
    { "parallax", "--method parallax" },
    { "parallax, not limited", "--method parallax --unlimited" },
    { "bump", "--method bump" },
    { "polygons", "--method polygons" },
    { .method = NULL },
};

static const char *const usual[] = { "layers", "layers, coarser", NULL };

static GpResult find_truth(void *model, int threads, GpError *error)
{
    const RayPicture *truth;
    return warp_model_truth(model, &warp_option_defaults, threads, &truth, error);
}

static GpResult find_error(void *model, const Frame *frame, WarpError *off, GpError *error)
{
    return warp_model_error(model, frame, machine_processors(), off, error);
}

static GpResult find_difference(void *made, const void *setting, GpDevice *device, Frame *frame,
                                float *off, GpError *error)
{
    const RayPicture *truth;
    const GpResult result =
        warp_model_truth(made, setting, gp_device_threads(device), &truth, error);
    if (!result)
        warp_difference(truth, frame->color, off);
    return result;
}

/* --- colours ---------------------------------------------------------------------------------- */

static const char *const color_metrics[] = { "decibels", "missing",    "extra",
                                             "depth",    "mean depth", NULL };

static GpResult measure_color(void *model, const Frame *frame, TechniqueError *measured,
                              GpError *error)
{
    WarpError off;
    const GpResult result = find_error(model, frame, &off, error);
    if (!result)
        *measured = (TechniqueError){ .error = 255 * off.rmse,
                                      .metrics = { off.interior_psnr, off.missing, off.extra,
                                                   off.depth_error, off.depth_mean },
                                      .whole = 255 };
    return result;
}

/* --- silhouettes ------------------------------------------------------------------------------ */

static const char *const outline_metrics[] = { "missing", "extra", NULL };

static GpResult measure_outline(void *model, const Frame *frame, TechniqueError *measured,
                                GpError *error)
{
    WarpError off;
    const GpResult result = find_error(model, frame, &off, error);
    if (!result)
        *measured = (TechniqueError){ .error = off.missing + off.extra,
                                      .metrics = { off.missing, off.extra },
                                      .whole = off.covered };
    return result;
}

/* --- depth ------------------------------------------------------------------------------------ */

static const char *const depth_metrics[] = { "depth", NULL };

/* Of a thousandth of the model's size, so that models compare. */
static GpResult measure_depth(void *made, const Frame *frame, TechniqueError *measured,
                              GpError *error)
{
    const WarpModel *model = made;
    WarpError off;
    const GpResult result = find_error(made, frame, &off, error);
    if (!result)
        *measured =
            (TechniqueError){ .error = 1000 * off.depth_mean / bounds_longest(&model->bounds),
                              .metrics = { off.depth_error },
                              .whole = 1000 };
    return result;
}

#define WARP_EXPERIMENT                                                                            \
    .scene = "builtin:teapot", .sweep = sweep, .usual = usual, .words = warp_words,                \
    .truth = warp_truth_words, .difference = find_difference, .over = "brighter than in truth",    \
    .under = "darker", .find_truth = find_truth

const Experiment warp_experiments[] = {
    { .name = "warp",
      .title = "Depth images: time against error of colours",
      .error_name = "codes",
      .part_of = "the whole range of a colour",
      .metrics = color_metrics,
      .measure = measure_color,
      WARP_EXPERIMENT },
    { .name = "outlines",
      .title = "Depth images: time against wrong outlines",
      .error_name = "wrong pixels",
      .part_of = "the covered pixels",
      .metrics = outline_metrics,
      .measure = measure_outline,
      WARP_EXPERIMENT },
    { .name = "depths",
      .title = "Depth images: time against error of depth",
      .error_name = "thousandths",
      .part_of = "the model's longest side",
      .metrics = depth_metrics,
      .measure = measure_depth,
      WARP_EXPERIMENT },
    { .name = NULL },
};
