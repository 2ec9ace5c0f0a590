#include "apps/techniques/warp/scaling.h"

#include "apps/techniques/warp/model.h"

static double side(const void *scene, const Frame *frame)
{
    (void)scene;
    return ((const WarpOptions *)frame->made)->source_size[0];
}

static double angle(const void *scene, const Frame *frame)
{
    (void)scene;
    return ((const WarpOptions *)frame->made)->turn;
}

#define SIDES "--source-size 64x64|128x128|256x256|512x512|1024x1024"
#define TURNS "--turn 2|5|12|30|75"
#define MODEL "builtin:teapot"

static const TechniqueLine with_pixels[] = {
    { "as a surface", MODEL, "--method surface --step 1 " SIDES },
    { "polygons", MODEL, "--method polygons " SIDES },
    { .name = NULL },
};

static const TechniqueLine with_turns[] = {
    { "as a surface", MODEL, "--method surface " TURNS },
    { "polygons", MODEL, "--method polygons " TURNS },
    { .name = NULL },
};

static const TechniqueSlope pixel_slopes[] = { { 1, "as the side" },
                                               { 2, "as the square" },
                                               { .name = NULL } };
static const TechniqueSlope turn_slopes[] = { { .name = NULL } };

static const char *const scaling_text[] = {
    "A grid has a vertex for each pixel of the image, so that its time grows with the square of "
    "the "
    "image's side once triangles cost more than the pixels that they fill. Where flat places are "
    "merged it grows with how much there is to be seen in the image, which is less. Polygons do "
    "not "
    "know the image.",
    "A view from farther aside looks at the same image: what is drawn stays the same, and what "
    "grows is the error.",
    NULL
};

static const TechniqueWord scaling_words[] = {
    { "pixels a side", "Pixels of the depth image along each side." },
    { "degrees aside", "How far the view is turned from the source." },
    { "as a surface", "The depth image as a mesh of few triangles." },
    { "polygons", "The mesh that the image was taken of." },
    { .word = NULL },
};

const TechniqueScaling warp_scaling = {
    .title = "Depth images: time against their size, and against the view's angle",
    .text = scaling_text,
    .words = scaling_words,
    .panels = { { .title = "Larger images, in the same picture",
                  .axis = "pixels a side",
                  .doubles = true,
                  .amount = side,
                  .lines = with_pixels,
                  .slopes = pixel_slopes },
                { .title = "Views from farther aside",
                  .axis = "degrees aside",
                  .amount = angle,
                  .lines = with_turns,
                  .slopes = turn_slopes } },
};
