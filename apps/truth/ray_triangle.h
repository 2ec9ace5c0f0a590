/* Where a ray meets a triangle, such that no ray slips through between neighbours.
 *
 * Space is sheared so that the ray becomes the z axis, and the triangle is met where its flat image
 * holds (0, 0). Why there are no cracks: a corner's image depends on nothing but the ray and the
 * corner, so neighbours agree on it; and the sign of an edge value x1 y2 - x2 y1 is right or 0,
 * because rounding keeps the order of the two products. As 0 counts as inside on both sides of an
 * edge, a triangle whose image truly holds (0, 0) is never missed.
 *
 * source Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013
 */
#ifndef APPS_TRUTH_RAY_TRIANGLE_H
#define APPS_TRUTH_RAY_TRIANGLE_H

#include "apps/base/vector.h"

#include <stdbool.h>

typedef struct TruthTriangle {
    double corner[3][3];
} TruthTriangle;

typedef struct TruthRay {
    double origin[3], direction[3];
    double shear[3]; /* what a step along axis[2] adds to axis[0] and axis[1], and to t */
    int axis[3];     /* axis[2] is that of the direction's largest component */
} TruthRay;

/* A ray through origin; direction of any length but 0. */
static inline TruthRay truth_ray(const double origin[3], const double direction[3])
{
    TruthRay ray;
    int z = 0;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = origin[i];
        ray.direction[i] = direction[i];
        z = fabs(direction[i]) > fabs(direction[z]) ? i : z;
    }
    for (int i = 0; i < 3; i++)
        ray.axis[i] = (z + 1 + i) % 3;
    ray.shear[0] = direction[ray.axis[0]] / direction[z];
    ray.shear[1] = direction[ray.axis[1]] / direction[z];
    ray.shear[2] = 1 / direction[z];
    return ray;
}

static inline void truth_shear(const TruthRay *ray, const double corner[3], double out[3])
{
    const int *axis = ray->axis;
    double z = corner[axis[2]] - ray->origin[axis[2]];
    out[0] = corner[axis[0]] - ray->origin[axis[0]] - ray->shear[0] * z;
    out[1] = corner[axis[1]] - ray->origin[axis[1]] - ray->shear[1] * z;
    out[2] = ray->shear[2] * z;
}

/* Meets the line of a ray with a triangle, seen from either side.
 * out    t: the point is origin + t * direction, t of any sign; share: the corners' weights in that
 *        point, in [0, 1], sum 1; both untouched without a meeting
 * note   a triangle seen exactly from its edge is not met */
static inline bool truth_ray_triangle(const TruthRay *ray, const TruthTriangle *triangle, double *t,
                                      double share[3])
{
    double a[3], b[3], c[3];
    truth_shear(ray, triangle->corner[0], a);
    truth_shear(ray, triangle->corner[1], b);
    truth_shear(ray, triangle->corner[2], c);
    double u = c[0] * b[1] - c[1] * b[0];
    double v = a[0] * c[1] - a[1] * c[0];
    double w = b[0] * a[1] - b[1] * a[0];
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0))
        return false;
    double area = u + v + w;
    if (area == 0)
        return false;
    share[0] = u / area;
    share[1] = v / area;
    share[2] = w / area;
    *t = share[0] * a[2] + share[1] * b[2] + share[2] * c[2];
    return true;
}

#endif
