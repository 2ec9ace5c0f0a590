#include "apps/techniques/points/experiments.h"

#include "apps/techniques/points/model.h"
#include "apps/techniques/points/words.h"

#include <math.h>

static const TechniqueSweep sweep[] = {
    { "both filters", "--method ewa --lowpass 0.3|0.4|0.5" },
    { "both filters, far cut", "--method ewa --cut 3" },
    { "sums of floats", "--method ewa --sums float" },
    { "sums of bytes", "--method ewa --sums byte" },
    { "reconstruction alone", "--method reconstruction" },
    { "low-pass alone", "--method lowpass" },
    { "by areas, as printed", "--method area" },
    { "by distances, as printed", "--method distance" },
    { "ours", "--method adaptive --tolerance 0.02|0.05|0.1" },
    { "ours, merged", "--method adaptive --detail 0.35|0.5|0.7|1" },
    { "one pass", "--method ternary --epsilon 2|4|8" },
    { "by rays", "--method perspective" },
    { "quads", "--method quads" },
    { "8 bytes a point", "--method ewa --compress ours" },
    { "8 bytes a point, as printed", "--method ewa --compress printed" },
    { "discs", "--method sprites" },
    { "pixels", "--method pixels" },
    { "tree of squares", "--method qsplat --detail 1|2|4" },
    { "sequence of squares", "--method spt --detail 1|2|4" },
    { .method = NULL },
};

static const char *const usual[] = { "ours", "both filters", "ours, merged", NULL };
static const char *const metrics[] = { "decibels", "area",  "holes", "largest",
                                       "covered",  "bytes", NULL };

static GpResult find_truth(void *made, int threads, GpError *error)
{
    return points_model_truth(made, threads, error);
}

static GpResult measure(void *made, const Frame *frame, TechniqueError *measured, GpError *error)
{
    const PointsModel *model = made;
    (void)error;
    const PointsError off = points_error(&model->truth, frame->color);
    *measured = (TechniqueError){
        .error = 255 * off.rmse,
        .metrics = { off.interior_psnr, 100 * off.area_error, off.holes, 255 * off.largest,
                     off.covered, points_model_bytes(model, frame->made) / model->point_count },
        .whole = 255
    };
    return GP_OK;
}

static GpResult find_difference(void *made, const void *setting, GpDevice *device, Frame *frame,
                                float *off, GpError *error)
{
    const PointsModel *model = made;
    (void)setting;
    (void)device;
    (void)error;
    points_difference(&model->truth, frame->color, off);
    return GP_OK;
}

const Experiment points_experiments[] = {
    { .name = "points",
      .title = "Points as splats: time against error",
      .scene = "builtin:knot",
      .sweep = sweep,
      .usual = usual,
      .error_name = "codes",
      .part_of = "the whole range of a colour",
      .metrics = metrics,
      .words = points_words,
      .truth = points_truth_words,
      .difference = find_difference,
      .over = "brighter than in truth",
      .under = "darker",
      .find_truth = find_truth,
      .measure = measure },
    { .name = NULL },
};
