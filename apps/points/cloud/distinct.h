/* Points at places of their own. */
#ifndef APPS_POINTS_CLOUD_DISTINCT_H
#define APPS_POINTS_CLOUD_DISTINCT_H

#include "pipeline/base/base.h"

/* Lists, in their order, the first point of each place.
 * in     positions: [3 * count], finite; 0 and -0 are one
 * out    numbers: [count], of which *distinct are set
 * errors GP_ERROR_MEMORY */
GpResult distinct_places(const float *positions, uint32_t count, uint32_t *numbers,
                         uint32_t *distinct);

#endif
