/* Normals of points that have none: planes through their neighbours, turned the same way all
 * over. */
#ifndef APPS_POINTS_CLOUD_PLANES_H
#define APPS_POINTS_CLOUD_PLANES_H

#include "apps/points/cloud/neighbours.h"

/* Points that reach each other over neighbours. */
typedef struct PlaneFacts {
    uint32_t estimated;  /* normals */
    uint32_t undefined;  /* of them: neighbours on a line leave the normal open */
    uint32_t components; /* sets of points that no neighbours connect */
} PlaneFacts;

enum { PLANES_NEIGHBOURS = 16, PLANES_LINKS = 8 };

/* Estimates the normals that are (0, 0, 0), and makes the others unit length.
 *
 * A normal is the direction in which the point and its PLANES_NEIGHBOURS nearest spread least.
 * Where they lie on a line, it is the one across the line that is nearest to z (to y, where the
 * line runs along z).
 *
 * Its side is found along a spanning tree over each point's PLANES_LINKS nearest, of which the
 * weight 1 - |a . b| between the normals of two neighbours is least (in steps of 1/1023): along
 * each link, the two look the same way. A component in which points had normals is turned as most
 * of these look. Another is turned so that its flux is positive, the sum over its points of their
 * area (from the distance to the last link) times normal . (place - centre): of a closed surface,
 * three times the volume, so that normals look outwards; one that is concave all over, such as the
 * inside of a bowl, looks away from its centre as well. A flat one, whose flux is nothing, looks to
 * where its largest coordinate is positive.
 *
 * in/out normals: [3 * tree->count], by number
 * order  the same for any number of threads
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: 2^29 points or more
 * source Hoppe, DeRose, Duchamp, McDonald and Stuetzle, "Surface reconstruction from unorganized
 *        points", SIGGRAPH 1992, 3.2 and 3.3; the flux is ours */
GpResult planes_estimate(const NeighbourTree *tree, GpPool *pool, float *normals,
                         PlaneFacts *facts);

#endif
