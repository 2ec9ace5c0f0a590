#include "apps/techniques/warp/words.h"

const char warp_truth_words[] =
    "The mesh itself: a ray through each pixel's centre is cast at every triangle in double "
    "precision, and what it meets first is lit.";

const TechniqueWord warp_words[] = {
    { "codes",
      "How far red, green and blue are from the truth over the whole picture on black, outlines "
      "included, as the root of the mean square, of 255." },
    { "wrong pixels",
      "Pixels that are covered and should not be, and pixels that should be and are not." },
    { "thousandths",
      "How far depth along the view is off, on the average over pixels that the truth covers too, "
      "in thousandths of the model's longest side." },
    { "decibels",
      "The error of colours alone, over pixels that both cover, as peak signal to noise "
      "ratio." },
    { "missing", "Pixels that the truth covers, and the picture does not." },
    { "extra", "Pixels that the picture covers, and the truth does not." },
    { "depth", "How far depth along the view is off, the median, in the model's unit." },
    { "mean depth", "How far depth along the view is off, on the average, in the same unit." },
    { "layers", "A grid over the image, flat places of which are merged, cut where surfaces end; "
                "the holes that open there are filled from a second layer, of what lies behind." },
    { "layers, coarser", "The same with a vertex for every second or fourth pixel only." },
    { "front alone", "Without the second layer: holes stay open." },
    { "front, cut at 2 %", "Without it, and cut wherever depth steps by more than a fiftieth, so "
                           "that slopes have holes." },
    { "front, not cut", "Without it, and whole: rubber sheets hang between near and far." },
    { "as printed",
      "A cell for every four pixels, moved within a plane by a table, without a depth test, in an "
      "order in which what is nearer comes later; and that plane as a picture on its rectangle." },
    { "as printed, cut", "The same, with no cell where surfaces end." },
    { "as a surface",
      "Another grid of the front, of as few triangles as stand for it within a quarter of a pixel, "
      "for cylinders too." },
    { "cylinder, as a surface",
      "The same of a depth image on a cylinder around the model, with two caps." },
    { "depth mesh",
      "A triangle for every three pixels side by side, cut at steps of 2 %, in the world." },
    { "depth mesh, simplified", "The same with a tenth of the triangles, by quadrics." },
    { "cylinder, as printed",
      "A depth image on a cylinder, moved within the plane that touches the cylinder before the "
      "eye, without a depth test, in an order in which what is nearer comes later." },
    { "relief",
      "Relief mapping: each pixel's ray goes through the depth image in even steps until it is "
      "below it, and the last of these is then halved." },
    { "displacement", "Each pixel's ray goes through a field of distances to the surface in steps "
                      "as long as these." },
    { "relief texture",
      "The image is warped by the processor as it has to be on a rectangle, row by row and column "
      "by column, for each frame; that time is not in the chart. Gaps at steps of 2 % stay open." },
    { "relief texture, not cut", "The same with all gaps filled, as printed." },
    { "parallax",
      "The image on a rectangle, its places shifted by their depths, at most as far as these." },
    { "parallax, not limited", "The same, shifted as far as the view's slope has it." },
    { "bump", "The image on a rectangle, lit by its normals." },
    { "polygons", "The mesh itself, drawn as triangles." },
    { .word = NULL },
};
