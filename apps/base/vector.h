/* Three doubles. */
#ifndef APPS_BASE_VECTOR_H
#define APPS_BASE_VECTOR_H

#include <math.h>

static inline void vector_set(double out[3], double x, double y, double z)
{
    out[0] = x;
    out[1] = y;
    out[2] = z;
}

static inline void vector_widen(const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

static inline double vector_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void vector_cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void vector_subtract(const double a[3], const double b[3], double out[3])
{
    vector_set(out, a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/* out = a + scale * b; out may be a. */
static inline void vector_add_scaled(const double a[3], double scale, const double b[3],
                                     double out[3])
{
    vector_set(out, a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]);
}

/* The largest of the absolute components. */
static inline double vector_extent(const double a[3])
{
    return fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2])));
}

/* Scales to length 1; the zero vector stays. */
static inline void vector_normalize(double a[3])
{
    const double length = sqrt(vector_dot(a, a));
    if (length > 0)
        vector_set(a, a[0] / length, a[1] / length, a[2] / length);
}

#endif
