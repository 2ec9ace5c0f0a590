/* The end of waiting: a pixel's fragments are sorted and blended. */
#ifndef GP_FAST_BLEND_SORTED_H
#define GP_FAST_BLEND_SORTED_H

#include "pipeline/fast/lanes/shade/fragments.h"

/* Sorts all that waits, tests it where that comes last, blends it, and empties the lists. */
void fast_blend_sorted(Tile *tile);

#endif
