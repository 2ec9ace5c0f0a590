/* Exact distances from points of a box to what stands in it as columns: the field by which rays
 * know how far they may go. */
#ifndef APPS_DEPTH_IMAGES_RIVALS_DISTANCE_FIELD_H
#define APPS_DEPTH_IMAGES_RIVALS_DISTANCE_FIELD_H

#include "pipeline/base/base.h"

/* One column stands on each of size[0] x size[1] samples, from its z in the box, 0 to 1, on by
 * `thickness`. Borrowed. */
typedef struct DistanceColumns {
    const float *z; /* [size[1]][size[0]]; above 1: there is none */
    double thickness;
    uint32_t size[3]; /* samples along x, y, z, at least 2 each; the first at 0, the last at 1 */
    double metric[3]; /* lengths of the box's sides */
} DistanceColumns;

/* Distances as codes: 255 is `reach` and more, and what is between is rounded down, since rays must
 * not go too far.
 * out    codes: [size[2]][size[1]][size[0]]
 * errors GP_ERROR_MEMORY
 * source Felzenszwalb, Huttenlocher, "Distance transforms of sampled functions", Theory of
 *        Computing 8, 2012; columns that end between samples: ours */
GpResult distance_field_make(const DistanceColumns *columns, double reach, uint8_t *codes);

#endif
