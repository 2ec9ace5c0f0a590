/* Interpolants from barycentrics, in the model's operations (CONVENTIONS.md). */
#ifndef GP_FAST_INTERPOLATE_H
#define GP_FAST_INTERPOLATE_H

#include "pipeline/fast/lanes/memory/packet.h"

/* Barycentrics of a block's packets: weights of corners 1 and 2, on the screen and in
 * perspective. */
typedef struct FastWeights {
    flt screen[2][FAST_BLOCK], perspective[2][FAST_BLOCK];
    bool has_perspective; /* otherwise those on the screen serve, too */
} FastWeights;

/* The latter from the former, of packet p; ratios: 1/w of corners 1 and 2 over that of corner 0. */
GP_INLINE void correct_weights(FastWeights *weights, int p, flt ratio1, flt ratio2)
{
    const flt weight1 = weights->screen[0][p], weight2 = weights->screen[1][p];
    flt rw = 1.0f + (weight1 * (ratio1 - 1.0f) + weight2 * (ratio2 - 1.0f));
    flt w = 1.0f / rw;
    weights->perspective[0][p] = weight1 * ratio1 * w;
    weights->perspective[1][p] = weight2 * ratio2 * w;
}

/* The place of pixels, in sub-pixels, along one axis of a sprite, 0..1. */
GP_INLINE flt place_in_sprite(itg subpixel, int32_t start, float per_step)
{
    return flt_from_itg(subpixel - start) * per_step;
}

#endif
