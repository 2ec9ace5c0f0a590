/* A triangle in double: its box, its normal, what lies above and below it, and how far it is. */
#ifndef APPS_TRUTH_TRIANGLE_H
#define APPS_TRUTH_TRIANGLE_H

#include "apps/truth/ray_triangle.h"

/* Of the corners, along an axis. */
static inline void truth_bounds(const TruthTriangle *t, int axis, double *low, double *high)
{
    *low = fmin(t->corner[0][axis], fmin(t->corner[1][axis], t->corner[2][axis]));
    *high = fmax(t->corner[0][axis], fmax(t->corner[1][axis], t->corner[2][axis]));
}

/* Of twice the triangle's area as its length. */
static inline void truth_normal(const TruthTriangle *t, double normal[3])
{
    double edge[2][3];
    vector_subtract(t->corner[1], t->corner[0], edge[0]);
    vector_subtract(t->corner[2], t->corner[0], edge[1]);
    vector_cross(edge[0], edge[1], normal);
}

/* --- along an axis ---------------------------------------------------------------------------- */

/* A triangle along an axis: u and v are the next two. */
typedef struct TruthProjection {
    int axis, u, v;
    double corner[3][2];
    double area; /* twice, with its sign */
} TruthProjection;

static inline TruthProjection truth_project(const TruthTriangle *t, int axis)
{
    TruthProjection p = { .axis = axis, .u = (axis + 1) % 3, .v = (axis + 2) % 3 };
    for (int i = 0; i < 3; i++) {
        p.corner[i][0] = t->corner[i][p.u];
        p.corner[i][1] = t->corner[i][p.v];
    }
    p.area = (p.corner[1][0] - p.corner[0][0]) * (p.corner[2][1] - p.corner[0][1]) -
             (p.corner[1][1] - p.corner[0][1]) * (p.corner[2][0] - p.corner[0][0]);
    return p;
}

/* Where the triangle's plane lies over a point; normal[p->axis] is not 0. */
static inline double truth_depth(const TruthTriangle *t, const double normal[3],
                                 const TruthProjection *p, double u, double v)
{
    const double *c = t->corner[0];
    return c[p->axis] -
           (normal[p->u] * (u - c[p->u]) + normal[p->v] * (v - c[p->v])) / normal[p->axis];
}

/* Whether a point is left of the edge from a to b, the same from both sides but for the sign: the
 * ends are put in order first, and a point on the line is left of those that run one way. */
static inline bool truth_is_left(const double a[2], const double b[2], double u, double v)
{
    bool turned = a[0] > b[0] || (a[0] == b[0] && a[1] > b[1]);
    const double *from = turned ? b : a, *to = turned ? a : b;
    double side = (to[0] - from[0]) * (v - from[1]) - (to[1] - from[1]) * (u - from[0]);
    return (side >= 0) != turned;
}

/* Whether the triangle's image holds a point: of two that share an edge, one holds a point on
 * it. */
static inline bool truth_covers(const TruthProjection *p, double u, double v)
{
    int left = 0;
    for (int i = 0; i < 3; i++)
        left += truth_is_left(p->corner[i], p->corner[(i + 1) % 3], u, v);
    return left == 0 || left == 3;
}

/* --- distance --------------------------------------------------------------------------------- */

static inline double truth_square_to_segment(const double p[3], const double a[3],
                                             const double b[3])
{
    double along[3], from[3], off[3];
    vector_subtract(b, a, along);
    vector_subtract(p, a, from);
    double length = vector_dot(along, along);
    double t = length > 0 ? fmin(fmax(vector_dot(from, along) / length, 0), 1) : 0;
    for (int k = 0; k < 3; k++)
        off[k] = from[k] - t * along[k];
    return vector_dot(off, off);
}

/* To the plane where the foot is inside all edges, else to the nearest edge. */
static inline double truth_square_to_triangle(const double p[3], const TruthTriangle *t)
{
    double normal[3], from[3], nearest = HUGE_VAL;
    bool inside = true;
    truth_normal(t, normal);
    for (int i = 0; i < 3; i++) {
        const double *a = t->corner[i], *b = t->corner[(i + 1) % 3];
        double edge[3], out[3];
        vector_subtract(b, a, edge);
        vector_subtract(p, a, from);
        vector_cross(normal, edge, out);
        inside = inside && vector_dot(out, from) >= 0;
        nearest = fmin(nearest, truth_square_to_segment(p, a, b));
    }
    double height = vector_dot(normal, from), square = vector_dot(normal, normal);
    return inside && square > 0 ? height * height / square : nearest;
}

#endif
