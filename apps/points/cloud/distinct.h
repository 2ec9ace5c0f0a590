/* Points at places of their own. */
#ifndef APPS_POINTS_CLOUD_DISTINCT_H
#define APPS_POINTS_CLOUD_DISTINCT_H

#include "pipeline/base/base.h"

/* Finds the first point at the place of each.
 * in     positions: [3 * count], finite; 0 and -0 are one
 * out    first: [count], of the points, at most the point itself
 * errors GP_ERROR_MEMORY */
GpResult places_find(const float *positions, uint32_t count, uint32_t *first);

/* Lists, in their order, the first point of each place.
 * in     positions: as for places_find
 * out    numbers: [count], of which *distinct are set
 * errors GP_ERROR_MEMORY */
GpResult distinct_places(const float *positions, uint32_t count, uint32_t *numbers,
                         uint32_t *distinct);

#endif
