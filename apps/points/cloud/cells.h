/* What points of a surface reach and stand for, from where their neighbours are. */
#ifndef APPS_POINTS_CLOUD_CELLS_H
#define APPS_POINTS_CLOUD_CELLS_H

#include "apps/points/cloud/neighbours.h"

typedef struct CellFacts {
    double nearest_sum, nearest_least, nearest_most; /* distances to the nearest other point */
    uint32_t boundary; /* points that are at the surface's boundary or at a hole of it */
} CellFacts;

/* A point's cell is what of its tangent plane is nearer to it than to its neighbours there (its
 * Voronoi cell). Discs that reach the farthest corner of their cells just close the surface; areas
 * of cells add up to its own.
 *
 * Of the CELLS_NEIGHBOURS nearest those count that look the same way and do not stand higher over
 * the plane than beside the point: others are of another sheet. Each is taken at its true distance,
 * whatever the bend. A cell that reaches beyond the last of them is open: the point is at a
 * boundary. It then ends half the distance to its third neighbour away where it is open, and its
 * disc reaches its corners between neighbours as far as the fourth; but no farther than twice the
 * least disc among its four nearest, so that a point far from all others stays small.
 *
 * in     normals: [3 * tree->count] by number, unit length; places differ from each other
 * out    radii, areas: [tree->count] by number, above 0
 * order  the same for any number of threads
 * errors GP_ERROR_MEMORY
 * source ours */
GpResult cells_measure(const NeighbourTree *tree, const float *normals, GpPool *pool, float *radii,
                       float *areas, CellFacts *facts);

enum { CELLS_NEIGHBOURS = 16 };

#endif
