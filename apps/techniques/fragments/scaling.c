#include "apps/techniques/fragments/scaling.h"

#include "apps/techniques/fragments/model.h"

static double layers_of(const void *scene, const Frame *frame)
{
    (void)frame;
    return ((const FragmentModel *)scene)->count.layers;
}

static double in_flight(const void *scene, const Frame *frame)
{
    (void)scene;
    return ((const FragmentOptions *)frame->made)->hazard;
}

/* Of 1,520 triangles each, so that pieces of all are made in seconds. */
#define GROWING                                                                                    \
    "builtin:spheres:16:40|builtin:spheres:32:40|builtin:spheres:48:40|builtin:spheres:64:40|"     \
    "builtin:spheres:80:40|builtin:spheres:96:40"

static const TechniqueLine with_layers[] = {
    { "sorted by the machine", GROWING, "--method sorted" },
    { "convex pieces", GROWING, "--method convex --tolerance 0.00001" },
    { "peeling", GROWING, "--method dp" },
    { "dual peeling", GROWING, "--method ddp" },
    { "adaptive buckets", GROWING, "--method adaptive" },
    { "weighted", GROWING, "--method weighted" },
    { .name = NULL },
};

static const TechniqueLine with_hazards[] = {
    { "k-buffer", "builtin:knot", "--method kbuffer --kept 16 --hazard 1|16|256|4096" },
    { .name = NULL },
};

static const TechniqueSlope slopes[] = { { 1, "as the layers" },
                                         { 2, "as their square" },
                                         { .name = NULL } };
static const TechniqueSlope no_slopes[] = { { .name = NULL } };

static const char *const scaling_text[] = {
    "The scene is the paper's: a wall of spheres that grows deeper, each sphere two layers, of "
    "1,520 triangles where the paper's have 39,600. So the mesh grows with the layers, and a "
    "method that reads it once takes time as they do. Peeling reads all of it for each layer, and "
    "takes time as their square; dual peeling half as often.",
    "How many fragments are in flight changes what is lost, and not how long it takes.", NULL
};

static const TechniqueWord scaling_words[] = {
    { "layers", "Fragments of the pixel that has most." },
    { "fragments in flight", "Fragments that do not see what the others of their window write." },
    { "sorted by the machine",
      "The fragments of a pixel, sorted in the tile before they are blended." },
    { "convex pieces", "Pieces drawn front to back, all triangles once." },
    { "peeling",
      "The nearest fragments, then the nearest behind those: a reading for each layer." },
    { "dual peeling", "The nearest and the farthest: a reading for two layers." },
    { "adaptive buckets", "16 buckets where fragments are, in two readings." },
    { "weighted", "An average, in one reading." },
    { "k-buffer", "The nearest 16 fragments, kept in order as they come." },
    { .word = NULL },
};

const TechniqueScaling fragment_scaling = {
    .title = "Fragments in order: time against depth",
    .text = scaling_text,
    .words = scaling_words,
    .panels = { { .title = "Deeper scenes",
                  .axis = "layers",
                  .amount = layers_of,
                  .lines = with_layers,
                  .slopes = slopes },
                { .title = "More fragments in flight",
                  .axis = "fragments in flight",
                  .doubles = true,
                  .amount = in_flight,
                  .lines = with_hazards,
                  .slopes = no_slopes } },
};
