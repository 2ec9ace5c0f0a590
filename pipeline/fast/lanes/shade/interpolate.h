/* Interpolants from barycentrics, in the model's operations (CONVENTIONS.md). */
#ifndef GP_FAST_INTERPOLATE_H
#define GP_FAST_INTERPOLATE_H

#include "pipeline/fast/lanes/tile.h"

/* Barycentrics of a block's packets: shares of corners 1 and 2, on the screen and in perspective. */
typedef struct BlockShares {
    flt screen[2][FAST_BLOCK], perspective[2][FAST_BLOCK];
} BlockShares;

/* The latter from the former, of packet p; ratios: 1/w of corners 1 and 2 over that of corner 0. */
GP_INLINE void correct_shares(BlockShares *shares, int p, flt ratio1, flt ratio2)
{
    const flt share1 = shares->screen[0][p], share2 = shares->screen[1][p];
    flt rw = 1.0f + (share1 * (ratio1 - 1.0f) + share2 * (ratio2 - 1.0f));
    flt w = 1.0f / rw;
    shares->perspective[0][p] = share1 * ratio1 * w;
    shares->perspective[1][p] = share2 * ratio2 * w;
}

#endif
