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
    { "layers", MODEL, "--method layers --step 1 " SIDES },
    { "as printed", MODEL, "--method planar --step 1 " SIDES },
    { "depth mesh", MODEL, "--method dmesh " SIDES },
    { "relief", MODEL, "--method relief " SIDES },
    { "displacement", MODEL, "--method displacement " SIDES },
    { "cylinder, as printed", MODEL, "--kind cylinder --method cylinder --step 1 " SIDES },
    { "polygons", MODEL, "--method polygons " SIDES },
    { .name = NULL },
};

static const TechniqueLine with_turns[] = {
    { "layers", MODEL, "--method layers " TURNS },
    { "as printed", MODEL, "--method planar " TURNS },
    { "depth mesh", MODEL, "--method dmesh " TURNS },
    { "relief", MODEL, "--method relief " TURNS },
    { "displacement", MODEL, "--method displacement " TURNS },
    { "cylinder, as printed", MODEL, "--kind cylinder --method cylinder " TURNS },
    { "polygons", MODEL, "--method polygons " TURNS },
    { .name = NULL },
};

static const TechniqueSlope pixel_slopes[] = { { 1, "as the side" },
                                               { 2, "as the square" },
                                               { .name = NULL } };
static const TechniqueSlope turn_slopes[] = { { .name = NULL } };

static const char *const scaling_text[] = {
    "A grid has a vertex for each pixel of the image, so that its time grows with the square of "
    "the image's side once triangles cost more than the pixels that they fill. Where flat places "
    "are merged it grows with how much there is to be seen in the image, which is less. Polygons "
    "do not know the image.",
    "A view from farther aside looks at the same image: what is drawn stays the same, and what "
    "grows is the error.",
    NULL
};

static const TechniqueWord scaling_words[] = {
    { "pixels a side", "Pixels of the depth image along each side." },
    { "degrees aside", "How far the view is turned from the source." },
    { "layers", "A grid over the image, and one of what lies behind, with flat places merged." },
    { "as printed",
      "A cell for every four pixels, moved within a plane, in an order that needs no depth test." },
    { "depth mesh", "A triangle for every three pixels side by side." },
    { "relief", "A search along the ray of each pixel of the picture." },
    { "displacement", "Steps along that ray as long as a field of distances allows." },
    { "cylinder, as printed",
      "A grid over an image on a cylinder, in an order that needs no depth test." },
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
