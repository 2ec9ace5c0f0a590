#include "apps/points/filter.h"

#include <math.h>

/* R = s^2 (f/z)^2 P (I - n n^T) P^T with P = (I | -(x, y)/z): its larger eigenvalue is at most that
 * of P P^T, 1 + (x^2 + y^2)/z^2, and the product of both is s^4 (f/z)^4 (1 + (x^2 + y^2)/z^2)
 * cos^2. */
SplatExtent splat_extent(const PointView *view, double nearest, double farthest, double least,
                         double most, const Facing *facing)
{
    const double wide = view->axes.half_width, high = view->axes.half_height;
    const double near_scale = most * view->pixels / nearest;
    const double far_scale = least * view->pixels / farthest * fmax(facing->low, 0);
    return (SplatExtent){ .low = far_scale * far_scale,
                          .high = near_scale * near_scale * (1 + wide * wide + high * high) };
}
