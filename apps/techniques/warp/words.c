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
    { "as a surface",
      "The depth image as a mesh of as few triangles as stand for it within a quarter of a pixel, "
      "under the depth test." },
    { "cylinder, as a surface",
      "The same of a depth image on a cylinder around the model, with two caps." },
    { "cylinder, as printed",
      "A depth image on a cylinder, moved within the plane that touches the cylinder before the "
      "eye, "
      "without a depth test, in an order in which what is nearer comes later." },
    { "relief",
      "Relief mapping: each pixel's ray goes through the depth image in even steps until it is "
      "below it, and the last of these is then halved." },
    { "polygons", "The mesh itself, drawn as triangles." },
    { .word = NULL },
};
