#include "apps/base/bounds.h"

#include "pipeline/base/lanes/types.h"

#include <math.h>
#include <string.h>

const Bounds bounds_of_nothing = { { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                                   { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

void bounds_add(Bounds *bounds, const double point[3])
{
    for (int k = 0; k < 3; k++) {
        bounds->low[k] = point[k] < bounds->low[k] ? point[k] : bounds->low[k];
        bounds->high[k] = point[k] > bounds->high[k] ? point[k] : bounds->high[k];
    }
}

void bounds_join(Bounds *bounds, const Bounds *other)
{
    for (int k = 0; k < 3; k++) {
        bounds->low[k] = other->low[k] < bounds->low[k] ? other->low[k] : bounds->low[k];
        bounds->high[k] = other->high[k] > bounds->high[k] ? other->high[k] : bounds->high[k];
    }
}

double bounds_longest(const Bounds *bounds)
{
    double longest = 0;
    for (int k = 0; k < 3; k++) {
        const double side = bounds->high[k] - bounds->low[k];
        longest = side > longest ? side : longest;
    }
    return longest;
}

Bounds bounds_of(const float *positions, size_t stride, const uint32_t *indices, uint32_t count)
{
    const float far = HUGE_VALF;
    float low[3] = { far, far, far }, high[3] = { -far, -far, -far };
    for (uint32_t i = 0; i < count; i++) {
        float p[3];
        memcpy(p, (const char *)positions + stride * (indices ? indices[i] : i), sizeof p);
        GP_UNROLL
        for (int k = 0; k < 3; k++) {
            low[k] = p[k] < low[k] ? p[k] : low[k];
            high[k] = p[k] > high[k] ? p[k] : high[k];
        }
    }
    Bounds bounds;
    for (int k = 0; k < 3; k++) {
        bounds.low[k] = (double)low[k];
        bounds.high[k] = (double)high[k];
    }
    return bounds;
}
