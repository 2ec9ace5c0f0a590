#include "apps/techniques/voxel/words.h"

const char voxel_surface_truth[] =
    "The distance is measured to the triangles themselves, from points spread evenly over them, in "
    "double precision. The exact voxels of each size, for missing and extra, are those that a "
    "triangle touches, or for the method thin those met by lines through the centres of voxels; "
    "which of them a triangle meets is calculated triangle by triangle, in double precision.";

const char voxel_solid_truth[] =
    "Points spread evenly around the model are inside where an odd number of triangles lies above "
    "them (for the method winding number: where those that face up and down do not cancel out), in "
    "double precision. The exact voxels of each size, for missing and extra, are those whose "
    "centre is inside in the same way.";

/* --- sentences that stand in more than one table, or under the option's name as well ---------- */

static const char voxels[] =
    "How many voxels, the small cubes that the volume is made of, are set.";
static const char missing[] =
    "Voxels that are not set and belong to the exact result of the same size.";
static const char extra[] =
    "Voxels that are set and do not belong to the exact result of the same size.";
static const char conservative[] = "Every voxel that a triangle touches: the triangle is tested "
                                   "against the columns of voxels that "
                                   "it crosses, and its range in each is set.";
static const char thin[] =
    "Voxels in which a triangle meets one of the three lines through their centre, along the axes: "
    "fewer than those of conservative.";
static const char sheets[] =
    "The method as it was printed in 2004: the model is drawn along three axes, each triangle "
    "along the one that it faces most; its depth selects a bit of a pixel, bits are added up by "
    "blending, and the three volumes turned into one. Where two surfaces fall into one voxel, "
    "adding carries into the next.";
static const char layered[] =
    "Surfaces are peeled off one behind the other along one axis, and the voxel at each depth is "
    "set.";
static const char xor [] =
    "Each triangle turns over all voxels below it, so that those with an odd number of triangles "
    "above them remain.";
static const char winding[] =
    "As xor, but with signs: triangles that face up add one to what is below them, others subtract "
    "one, and what is not 0 is inside; parts that overlap or are nested stay full.";
static const char rows[] =
    "The method as it was printed in 2004: the surface by sheets along three axes, then each row "
    "of voxels filled between one surface and the next, and of the three answers the majority.";
static const char layered_solid[] = "Surfaces are peeled off one behind the other along one axis, "
                                    "and rows filled from each odd one to the next.";
static const char faces[] =
    "The model's depths as seen from the six faces of its box; what lies behind all of them is "
    "inside, so that cavities and bends that no face sees are filled.";

/* --- tables ----------------------------------------------------------------------------------- */

const TechniqueWord voxel_surface_words[] = {
    { "RMS distance, thousandths of the model's size",
      "How far the centres of set voxels are from the model's surface, or its surface from them, "
      "whichever is more: the root of the mean square, and 1 is a thousandth of the model's "
      "longest side." },
    { "voxels", voxels },
    { "missing", missing },
    { "extra", extra },
    { "conservative", conservative },
    { "thin", thin },
    { "sheets", sheets },
    { "sheets, add", sheets },
    { "sheets, or", "As sheets, add, with bits united instead of added, so that nothing carries." },
    { "sheets, one axis", "As sheets, or, drawn along one axis alone: surfaces that this axis runs "
                          "along get holes." },
    { "slices",
      "The oldest method: the whole model once for each layer of voxels, cut to it by two "
      "planes." },
    { "ldi", layered },
    { "layered depths", layered },
    { .word = NULL },
};

const TechniqueWord voxel_solid_words[] = {
    { "wrong volume, thousandths",
      "How much space is inside the model and not the voxels, or inside the voxels and not the "
      "model; 1 is a thousandth of what the model encloses." },
    { "voxels", voxels },
    { "missing", missing },
    { "extra", extra },
    { "xor", xor},
    { "winding", winding },
    { "winding number", winding },
    { "sheets", rows },
    { "rows of sheets", rows },
    { "slices",
      "The oldest method: the model once for each layer of voxels, cut to what lies before the "
      "layer's centres; each triangle there turns over the voxels that it covers." },
    { "ldi", layered_solid },
    { "layered depths", layered_solid },
    { "faces", faces },
    { "six faces", faces },
    { .word = NULL },
};

const TechniqueWord voxel_scaling_words[] = {
    { "voxels a side", "The volume is a cube of so many voxels along each edge." },
    { "triangles", "Of the mesh that is turned into voxels; its name is above its points." },
    { "conservative", conservative },
    { "thin", thin },
    { "sheets, add", sheets },
    { "solid: xor", xor},
    { .word = NULL },
};
