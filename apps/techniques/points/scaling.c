#include "apps/techniques/points/scaling.h"

#include "apps/techniques/points/model.h"

static double points(const void *scene, const Frame *frame)
{
    (void)frame;
    return ((const PointsModel *)scene)->point_count;
}

static double splats_width(const void *scene, const Frame *frame)
{
    (void)scene;
    return ((const PointsOptions *)frame->made)->splats.low_pass;
}

#define GROWING_MODELS                                                                             \
    "builtin:ball|builtin:torus|builtin:knot|meshes/horse.ply|meshes/dragon_res2.ply|"             \
    "meshes/igea.ply|meshes/happy_buddha.ply"
#define GROWING_FILTERS "--lowpass 0.25|0.5|1|2|4"

static const TechniqueLine with_points[] = {
    { "both filters", GROWING_MODELS, "--method ewa" },
    { "ours", GROWING_MODELS, "--method adaptive" },
    { "ours, merged", GROWING_MODELS, "--method adaptive --detail 0.7" },
    { "discs", GROWING_MODELS, "--method sprites" },
    { "pixels", GROWING_MODELS, "--method pixels" },
    { .name = NULL },
};

static const TechniqueLine with_filters[] = {
    { "both filters", "builtin:knot", "--method ewa " GROWING_FILTERS },
    { "sums of floats", "builtin:knot", "--method ewa --sums float " GROWING_FILTERS },
    { .name = NULL },
};

static const TechniqueSlope point_slopes[] = { { 1, "as their number" }, { .name = NULL } };
static const TechniqueSlope filter_slopes[] = { { 2, "as the square" }, { .name = NULL } };

static const char *const scaling_text[] = {
    "A splat costs twice: once for itself, to be placed and set up, and once for each pixel that "
    "it lies over, to be tested and added. While splats are larger than a pixel, more of them are "
    "smaller ones, so that pixels stay about as many and only the first cost grows; from there on "
    "none is smaller than the pixel's filter, and both grow with the number. Points that are "
    "merged where they would be smaller than that stop growing with the model.",
    "With a wider filter all splats are wider: pixels grow as the square of it, once it is wider "
    "than the splats themselves.",
    NULL
};

static const TechniqueWord scaling_words[] = {
    { "points", "Points of the model, whichever are seen." },
    { "the filter's width", "Standard deviation of the pixel's filter, in pixels." },
    { "both filters",
      "Every point as a spot as wide as its disc, and wider by the pixel's filter." },
    { "sums of floats", "The same with sums of 32 bits instead of 16." },
    { "ours", "Points whose spots keep both filters only where that can be seen." },
    { "ours, merged",
      "The same, with points drawn as one that are close together in the picture." },
    { "discs", "Points as round discs that face the eye, without filters." },
    { "pixels", "Each point one pixel." },
    { .word = NULL },
};

const TechniqueScaling points_scaling = {
    .title = "Points: time against number and width",
    .text = scaling_text,
    .words = scaling_words,
    .panels = { { .title = "Larger models",
                  .axis = "points",
                  .amount = points,
                  .lines = with_points,
                  .slopes = point_slopes },
                { .title = "Wider filters, of the builtin knot",
                  .axis = "the filter's width",
                  .doubles = true,
                  .amount = splats_width,
                  .lines = with_filters,
                  .slopes = filter_slopes } },
};
