/* How large splats of surfels are, from which follows what of their filters can be left out. */
#ifndef APPS_POINTS_FILTER_H
#define APPS_POINTS_FILTER_H

#include "apps/base/filter_bound.h"
#include "apps/points/cull.h"

/* What the splats of a patch's surfels have in common on the picture: low <= l2 <= l1 <= high. */
typedef struct SplatExtent {
    double low, high; /* square pixels */
} SplatExtent;

/* In a perspective view.
 * in   nearest, farthest: depths, above 0; least, most: standard deviations on the disc, in the
 *      model's unit; facing: cosines between normals and the ways to the eye */
SplatExtent splat_extent(const PointView *view, double nearest, double farthest, double least,
                         double most, const Facing *facing);

#endif
