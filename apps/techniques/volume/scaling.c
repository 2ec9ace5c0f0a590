#include "apps/techniques/volume/scaling.h"

#include "apps/techniques/volume/model.h"

static double side(const void *scene, const Frame *frame)
{
    (void)frame;
    return ((const VolumeModel *)scene)->field.size[0];
}

static double kernels_width(const void *scene, const Frame *frame)
{
    (void)scene;
    return ((const VolumeOptions *)frame->made)->splats.deviation;
}

#define GROWING_VOLUMES                                                                            \
    "builtin:marschner-lobb:32|builtin:marschner-lobb:64|builtin:marschner-lobb:128|"              \
    "builtin:marschner-lobb:256"
#define GROWING_KERNELS "--deviation 0.35|0.5|0.7|1|1.4"

static const TechniqueLine with_samples[] = {
    { "rays", GROWING_VOLUMES, "--method raycast" },
    { "planes", GROWING_VOLUMES, "--method slices" },
    { "splats", GROWING_VOLUMES, "--method splat" },
    { "slabs", GROWING_VOLUMES, "--method splat --sheets image" },
    { "quads", GROWING_VOLUMES, "--method splat --mode qd" },
    { .name = NULL },
};

static const TechniqueLine with_kernels[] = {
    { "splats", "builtin:marschner-lobb:64", "--method splat " GROWING_KERNELS },
    { "slabs", "builtin:marschner-lobb:64", "--method splat --sheets image " GROWING_KERNELS },
    { .name = NULL },
};

static const TechniqueSlope sample_slopes[] = { { 1, "as the side" },
                                                { 3, "as its cube" },
                                                { .name = NULL } };
static const TechniqueSlope kernel_slopes[] = { { 2, "as the square" }, { .name = NULL } };

static const char *const scaling_text[] = {
    "The volume fills the picture, whatever its size. Splats are as many as samples that show "
    "something, eight times as many at twice the side, and smaller by that: the pixels that they "
    "lie over only double, with the slices. So their own cost takes over, as the cube of the side. "
    "Rays are as many as pixels, and their steps grow with the side; so do planes.",
    "Wider kernels lie over more pixels, as the square of their width, once these are what costs.",
    NULL
};

static const TechniqueWord scaling_words[] = {
    { "samples a side", "Samples of the volume along each axis." },
    { "the kernel's width", "Standard deviation of the kernels, in samples." },
    { "rays", "A ray for each pixel, along which values are interpolated and classified." },
    { "planes", "Planes between slices, as many as there are slices, each over the picture." },
    { "splats", "Each sample that shows something as a spot, added up in slices." },
    { "slabs", "The same, cut into slabs of equal depth." },
    { "quads", "The same as two triangles each, instead of a spot." },
    { .word = NULL },
};

const TechniqueScaling volume_scaling = {
    .title = "Volumes: time against size",
    .text = scaling_text,
    .words = scaling_words,
    .panels = { { .title = "Larger volumes, in the same picture",
                  .axis = "samples a side",
                  .doubles = true,
                  .amount = side,
                  .lines = with_samples,
                  .slopes = sample_slopes },
                { .title = "Wider kernels",
                  .axis = "the kernel's width",
                  .amount = kernels_width,
                  .lines = with_kernels,
                  .slopes = kernel_slopes } },
};
