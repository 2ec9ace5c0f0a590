/* Surfels of points, of which normals and radii may be missing. */
#ifndef APPS_POINTS_CLOUD_H
#define APPS_POINTS_CLOUD_H

#include "apps/points/cloud/cells.h"
#include "apps/points/cloud/planes.h"
#include "apps/points/surfels.h"
#include "pipeline/io/points/points.h"

typedef struct CloudFacts {
    uint32_t duplicates;   /* points at the place of an earlier one, left out */
    uint32_t zero_normals; /* of those kept that had any, (0, 0, 0) */
    uint32_t zero_radii;
    PlaneFacts planes;
    CellFacts cells;
} CloudFacts;

/* A surfel for each place, of the first point there, in their order. Normals are made unit length;
 * those that are missing or zero are estimated (planes.h), radii that are missing or zero are those
 * that close the surface (cells.h); so are the areas that points stand for. Without colours they
 * are white.
 *
 * in     all: finds facts->planes.components also where no normal is missing, which takes a while
 * out    surfels and facts: untouched on failure
 * errors GP_ERROR_INVALID: all points are at one place and no radius is given; GP_ERROR_MEMORY;
 *        GP_ERROR_UNSUPPORTED: 2^29 points or more
 * owns   the caller, until surfels_free */
GpResult surfels_of_points(const GpPoints *points, bool all, GpPool *pool, Surfels *surfels,
                           CloudFacts *facts);

#endif
