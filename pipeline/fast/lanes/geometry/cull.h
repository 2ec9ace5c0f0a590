/* Culling and binning in lanes. */
#ifndef GP_FAST_CULL_H
#define GP_FAST_CULL_H

#include "pipeline/fast/draws/bin.h"
#include "pipeline/fast/lanes/names.h"

/* Bins a range of a pass's primitives, or as many as there is memory for: culls, clips where it
 * must, and keeps their order. */
void fast_bin_range(const FastPass *pass, FastRange *range);

#endif
