#include "apps/techniques/fragments/words.h"

const char fragment_truth_words[] =
    "Every fragment under each pixel's centre, of both sides of the triangles, found by brute "
    "force in double precision, sorted by exact depth, of one depth by the order of triangles, and "
    "put together front to back.";

const TechniqueWord fragment_words[] = {
    { "wrong pixels", "Pixels of which red, green or blue is more than 1/255 off the truth." },
    { "beyond edges", "Wrong pixels with no edge of a triangle within 1/256 pixel of their centre, "
                      "the step to which the machine rounds corners." },
    { "passes", "Passes of the frame, over the mesh or over all pixels." },
    { "bytes",
      "Memory of all surfaces that the frame needs beside its picture; of fragments that the "
      "machine sorts, what all of them take that wait in its tiles." },
    { "sorted by the machine",
      "The fragments of a pixel are kept where it is drawn, and sorted by depth before they are "
      "blended: a state of a pass, as tile-based hardware has had." },
    { "convex pieces", "Sets of faces that any line crosses at most twice, drawn whole, front to "
                       "back; where faces are in front of each other in a circle the machine "
                       "sorts." },
    { "convex pieces, as printed", "The same of pieces that are never turned over, put in order by "
                                   "the cells of a grid, by planes between neighbours, and by "
                                   "slabs where no plane parts them, and that may be "
                                   "concave by a part of the mesh's longest side; then layers are "
                                   "lost." },
    { "peeling", "The nearest fragments, then the nearest behind those, a pass for each layer." },
    { "dual peeling",
      "The nearest and the farthest fragments, then those next to them, two layers a pass." },
    { "k-buffer", "The nearest few fragments of a pixel, kept in order as they come; others are "
                  "lost." },
    { "k-buffer, 16 in flight", "The same where 16 fragments are in flight at once, and do not see "
                                "what the others write: of those of one pixel the last is kept." },
    { "k-buffer, 256 in flight", "The same with 256 in flight." },
    { "stencil routing",
      "The first few fragments of a pixel that are drawn, kept by a stencil that "
      "counts them, and sorted afterwards." },
    { "buckets", "16 parts of equal depth, of which each keeps one fragment, in one pass." },
    { "buckets, two passes",
      "8 parts of equal depth, of which each keeps the nearest and the farthest fragment." },
    { "adaptive buckets", "A first pass finds in which of 128 parts of the depth a pixel has "
                          "fragments, and gives each a bucket." },
    { "multi-depth test",
      "All fragments, each in 32 bits: depth in 16 of them, and colour in the others." },
    { "A-buffer", "All fragments of a pixel, as they are, sorted afterwards." },
    { "weighted", "An average of the fragments, the nearer the heavier, without any order." },
    { .word = NULL },
};
