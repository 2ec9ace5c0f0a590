#include "apps/techniques/points/words.h"

const char points_truth_words[] =
    "The triangles whose vertices the points are, with the same colours and the same light, on "
    "average over 8 x 8 places in each pixel, in double precision.";

const TechniqueWord points_words[] = {
    { "codes",
      "How far red, green and blue are from the truth in the interior, as the root of the mean "
      "square, of 255." },
    { "interior",
      "Pixels that the triangles cover wholly, and whose eight neighbours they do too: what is "
      "there does not depend on where the surface ends." },
    { "decibels", "The same error as peak signal to noise ratio: 20 log10 of 255 over codes." },
    { "area",
      "How much larger than in truth the covered area is, in per cent: the sum of alpha over all "
      "pixels." },
    { "holes", "Pixels of the interior in which nothing was drawn." },
    { "largest", "The error that 99.9 per cent of the interior's values stay below, of 255." },
    { "covered", "Pixels that the surface covers in truth, parts of pixels counted as such." },
    { "bytes",
      "Memory that a point takes, with its share of levels of detail where the method needs "
      "them." },
    { "splat", "A point, drawn as a spot that is densest in its middle." },
    { "both filters",
      "EWA splatting: each spot is as wide as the point's disc is on the picture, and wider by the "
      "pixel's own filter." },
    { "both filters, far cut", "The same, with spots that end at three standard deviations." },
    { "sums of floats", "Both filters, with sums of 32 bits instead of 16." },
    { "sums of bytes", "Both filters, with sums of 8 bits, which round what is added each time." },
    { "reconstruction alone",
      "Spots as wide as the discs are: those smaller than a pixel fall between pixels." },
    { "low-pass alone", "Round spots of one width: discs larger than that leave holes." },
    { "by areas, as printed", "Each patch of points takes both filters or one of them, by the "
                              "ratio of a disc's area to the "
                              "pixel filter's, as the thesis prints it." },
    { "by distances, as printed", "The same by distances, as the later paper prints it." },
    { "ours",
      "A filter is left out, or points are drawn as one, where a bound says how far a colour can "
      "be off by that, with both axes of a spot looked at; coarser discs find what is hidden." },
    { "ours, merged",
      "The same, where points that are close together on the picture are drawn as one." },
    { "one pass",
      "Both filters, with the nearest surface found while spots are added up: a spot in front "
      "takes away what was there, faint rims of spots too." },
    { "by rays", "Both filters, where the ray of each pixel meets the point's plane: right in wide "
                 "views too." },
    { "quads",
      "Both filters in the plane of each point, drawn as two triangles instead of one spot." },
    { "8 bytes a point",
      "Both filters, of points that are kept in 8 bytes each and taken apart as they are drawn: "
      "places along the axes of their patch's own box, normals on an octahedron, logarithms of "
      "radii." },
    { "8 bytes a point, as printed",
      "The same with the bits of the thesis: places along the world's axes, normals as two angles, "
      "one of 256 radii." },
    { "discs", "Points as round discs that face the eye; the nearest is seen." },
    { "tree of squares",
      "QSplat: points are merged until they are so many pixels wide, by a walk down the tree, and "
      "drawn as squares; the nearest is seen." },
    { "sequence of squares", "A sequential point tree: all points and those that stand for "
                             "several, in one list by size, of "
                             "which the shader drops what is too fine or too coarse." },
    { "pixels", "Each point is one pixel; the nearest is seen." },
    { .word = NULL },
};
