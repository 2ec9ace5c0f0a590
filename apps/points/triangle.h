/* What a triangle asks of the discs at its corners. */
#ifndef APPS_POINTS_TRIANGLE_H
#define APPS_POINTS_TRIANGLE_H

#include <math.h>

/* Squared length of a side. */
static inline double triangle_side(const float a[3], const float b[3])
{
    const double x = (double)b[0] - (double)a[0];
    const double y = (double)b[1] - (double)a[1];
    const double z = (double)b[2] - (double)a[2];
    return x * x + y * y + z * z;
}

/* in  a, b, c: corners */
static inline double triangle_area(const float a[3], const float b[3], const float c[3])
{
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)b[i] - (double)a[i];
        v[i] = (double)c[i] - (double)a[i];
    }
    const double x = u[1] * v[2] - u[2] * v[1];
    const double y = u[2] * v[0] - u[0] * v[2];
    const double z = u[0] * v[1] - u[1] * v[0];
    return sqrt(x * x + y * y + z * z) / 2;
}

/* The largest distance of any of its points to the nearest corner: around corners, discs of that
 * radius and no smaller leave no hole of it.
 *
 * Each corner is nearest in a part that perpendicular bisectors bound. Where no angle is obtuse,
 * the parts meet at the centre of the circumscribed circle. Else that lies outside, and the
 * farthest points are where the bisectors of the short sides meet the long one: on it, at half the
 * short side's length divided by the cosine of the angle in between.
 * in  p, q, r: squared lengths of the sides */
static inline double triangle_reach(double p, double q, double r)
{
    /* r: the longest */
    if (p > r) {
        const double longer = p;
        p = r;
        r = longer;
    }
    if (q > r) {
        const double longer = q;
        q = r;
        r = longer;
    }
    const double obtuse = p + q - r; /* 2 sqrt(p q) times the cosine of the largest angle */
    if (obtuse > 0)
        return sqrt(p * q * r / (4 * p * q - obtuse * obtuse));
    const double at_p = p + r - q, at_q = q + r - p;
    const double x = at_p > 0 ? p / at_p : 0, y = at_q > 0 ? q / at_q : 0;
    return sqrt(r) * (x > y ? x : y);
}

#endif
