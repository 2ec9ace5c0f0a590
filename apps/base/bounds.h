/* Bounding boxes along the axes. */
#ifndef APPS_BASE_BOUNDS_H
#define APPS_BASE_BOUNDS_H

#include <stddef.h>
#include <stdint.h>

typedef struct Bounds {
    double low[3], high[3]; /* of nothing: infinite, and low above high */
} Bounds;

extern const Bounds bounds_of_nothing;

void bounds_add(Bounds *bounds, const double point[3]);
void bounds_join(Bounds *bounds, const Bounds *other);
double bounds_longest(const Bounds *bounds); /* side; 0 of nothing */

/* Those of the vertices that are referred to.
 * in   positions: three floats each, `stride` bytes apart
 *      indices: [count], NULL: all of the first `count` vertices */
Bounds bounds_of(const float *positions, size_t stride, const uint32_t *indices, uint32_t count);

#endif
