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
    { "polygons", "The mesh itself, drawn as triangles." },
    { .word = NULL },
};
