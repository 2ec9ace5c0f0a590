/* Interpolants from barycentrics, in the model's operations (CONVENTIONS.md). */
#ifndef GP_FAST_INTERPOLATE_H
#define GP_FAST_INTERPOLATE_H

#include "pipeline/fast/lanes/tile.h"

/* Barycentrics of a packet: shares on the screen, and perspective-correct ones. */
typedef struct Shares {
    flt screen[2], perspective[2];
} Shares;

GP_INLINE Shares shares_of(flt edge1, flt edge2, flt inverse_area, flt ratio1, flt ratio2)
{
    Shares s;
    s.screen[0] = edge1 * inverse_area;
    s.screen[1] = edge2 * inverse_area;
    flt rw = 1.0f + (s.screen[0] * (ratio1 - 1.0f) + s.screen[1] * (ratio2 - 1.0f));
    flt w = 1.0f / rw;
    s.perspective[0] = s.screen[0] * ratio1 * w;
    s.perspective[1] = s.screen[1] * ratio2 * w;
    return s;
}

GP_INLINE flt blend_corners(GpInterpolation mode, const Shares *shares, flt v0, flt v1, flt v2)
{
    if (mode == GP_FLAT)
        return v0;
    const flt *s = mode == GP_LINEAR_SCREEN ? shares->screen : shares->perspective;
    return v0 + (s[0] * (v1 - v0) + s[1] * (v2 - v0));
}

#endif
