/* How the values of a surface lie: of each channel the least, the largest, and a histogram. */
#ifndef APPS_INSPECT_RANGES_H
#define APPS_INSPECT_RANGES_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

enum { RANGE_BINS = 64 };

/* [{"low", "high", "odd", "bins": [RANGE_BINS counts]}, ...] of the channels that a format stores,
 * in order; of depth formats depth, then stencil codes. odd: values that are no finite numbers,
 * which count nowhere else; without any other, low and high are 0. Bins are of equal width from low
 * to high.
 * in   texels: [height][width], packed, as the surface's format has them
 * owns the caller */
json_t *ranges_tell(const GpSurface *surface, const uint8_t *texels);

#endif
