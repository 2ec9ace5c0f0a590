/* Triangles that rays are cast at, in double: what is seen, and what is between two points.
 *
 * The oracle of shadows. It shares no arithmetic with the pipeline, which knows no rays. It is
 * plain first, and quick enough for pictures of a million pixels.
 */
#ifndef APPS_TRUTH_RAY_SCENE_H
#define APPS_TRUTH_RAY_SCENE_H

#include "pipeline/base/base.h"
#include "apps/truth/ray_triangle.h"

#define TRUTH_NO_TRIANGLE UINT32_MAX

typedef struct TruthScene TruthScene;

typedef struct TruthHit {
    double t;          /* the point is origin + t * direction */
    double share[3];   /* the corners' weights in the point, sum 1 */
    uint32_t triangle; /* number in the scene */
} TruthHit;

/* Builds a scene of any number of triangles, 0 too; it keeps a copy.
 * errors GP_ERROR_INVALID (a coordinate that is not finite), GP_ERROR_MEMORY */
GpResult truth_scene_create(const TruthTriangle *triangles, uint32_t count, TruthScene **scene);
/* Tells why there is none. in result: truth_scene_create's, not GP_OK. returns result */
GpResult truth_scene_fail(GpError *error, GpResult result);
void truth_scene_destroy(TruthScene **scene); /* NULL-safe, sets NULL */

const TruthTriangle *truth_scene_triangle(const TruthScene *scene, uint32_t number);

/* Finds the triangle met first, from either side, at t > 0; of those at one t the lowest number.
 * in     direction: any length but 0
 * out    hit: untouched where nothing is met */
bool truth_first_hit(const TruthScene *scene, const double origin[3], const double direction[3],
                     TruthHit *hit);

/* Is anything strictly between two points?
 * in     from: usually a surface point, on triangle `skip`, which never blocks (TRUTH_NO_TRIANGLE:
 *        none)
 * note   No offset is needed, since the point lies on its own plane but for rounding. That matters
 *        only on an edge: there the neighbour is met at t = 0, just on this side or just on the
 *        other. So a meeting within 2^-40 of the largest coordinate from either end, far above
 *        rounding and far below any mesh's detail, is none. The same holds for copies of the
 *        triangle. Neighbours that fold towards the light shade as they should. */
bool truth_blocked(const TruthScene *scene, const double from[3], const double to[3],
                   uint32_t skip);

/* The same for everything in a direction, without an end. */
bool truth_blocked_along(const TruthScene *scene, const double from[3], const double direction[3],
                         uint32_t skip);

#endif
