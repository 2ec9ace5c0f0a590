/* Interpolants from barycentrics, in the model's operations (CONVENTIONS.md). */
#ifndef GP_FAST_INTERPOLATE_H
#define GP_FAST_INTERPOLATE_H

#include "pipeline/fast/lanes/memory/packet.h"

/* Barycentrics of a block's packets: weights of corners 1 and 2 of records, on the screen where
 * something is linear there, and in perspective. */
typedef struct FastWeights {
    flt screen[2][FAST_BLOCK], perspective[2][FAST_BLOCK];
    bool has_perspective; /* otherwise those on the screen serve, too */
} FastWeights;

/* The latter of packet p; parts: edge values times 1/w over that of corner 0. */
GP_INLINE void set_perspective(FastWeights *weights, int p, flt part0, flt part1, flt part2)
{
    const flt w = 1.0f / (part0 + (part1 + part2));
    weights->perspective[0][p] = part1 * w;
    weights->perspective[1][p] = part2 * w;
}

/* Takes the first neighbours away from a set of components, up to `most`; returns how many.
 * out  first: of them */
GP_INLINE int take_neighbours(uint64_t *components, int most, int *first)
{
    *first = __builtin_ctzll(*components);
    const unsigned near = (unsigned)(*components >> *first) & ((1u << most) - 1);
    const int found = __builtin_ctz(~near);
    *components &= ~((uint64_t)((1 << found) - 1) << *first);
    return found;
}

/* The place of pixels, in sub-pixels, along one axis of a sprite, 0..1. */
GP_INLINE flt place_in_sprite(itg subpixel, int32_t start, float per_step)
{
    return flt_from_itg(subpixel - start) * per_step;
}

#endif
