/* The 256 radii that stand for all of a model, in the printed compression. */
#ifndef APPS_POINTS_CLUSTERS_H
#define APPS_POINTS_CLUSTERS_H

#include "apps/points/surfels.h"

enum { CLUSTERS = 256 };

/* Clusters of the radii, rising; as many are equal as there are fewer.
 * source Dong Zhao's thesis, 3.3.2.5: "by cluster analysis". Lloyd's iteration over a histogram of
 *        the logarithms, begun with clusters of equal numbers: ours */
void clusters_find(const Surfel *surfels, uint32_t count, float radii[CLUSTERS]);

/* The nearest cluster, by bisection. */
uint8_t clusters_nearest(const float radii[CLUSTERS], float radius);

#endif
