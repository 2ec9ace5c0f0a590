/* Interpolants from barycentrics, in the model's operations (CONVENTIONS.md). */
#ifndef GP_FAST_INTERPOLATE_H
#define GP_FAST_INTERPOLATE_H

#include "pipeline/fast/lanes/tile.h"

/* Barycentrics of a packet: shares on the screen, and perspective-correct ones. */
typedef struct Shares {
    flt screen[2], perspective[2];
} Shares;

/* Perspective-correct shares from those on the screen; ratios: 1/w of corners 1 and 2 over that of 0. */
GP_INLINE void correct_shares(flt share1, flt share2, flt ratio1, flt ratio2, flt perspective[2])
{
    flt rw = 1.0f + (share1 * (ratio1 - 1.0f) + share2 * (ratio2 - 1.0f));
    flt w = 1.0f / rw;
    perspective[0] = share1 * ratio1 * w;
    perspective[1] = share2 * ratio2 * w;
}

GP_INLINE Shares shares_of(flt edge1, flt edge2, flt inverse_area, flt ratio1, flt ratio2)
{
    Shares s = { .screen = { edge1 * inverse_area, edge2 * inverse_area } };
    correct_shares(s.screen[0], s.screen[1], ratio1, ratio2, s.perspective);
    return s;
}

#endif
