/* Loose pixels of ordered draws: the few that each of many small triangles covers, side by side. */
#include "pipeline/fast/lanes/loose.h"

/* --- filling ------------------------------------------------------------------------------------ */

static bool is_taken(const FastMix *mix, unsigned live, uint32_t first)
{
    msk taken = itg_set(0);
    for (; live; live &= live - 1)
        taken |= (msk)(mix->at == (int32_t)first + __builtin_ctz(live));
    return msk_bits(taken);
}

bool FAST(mix_takes)(const FastMix *mix, int32_t x, int32_t y, unsigned live)
{
    return __builtin_popcount(mix->live) + __builtin_popcount(live) <= GP_LANES &&
           !is_taken(mix, live, fast_at(x, y));
}

void FAST(mix_begin)(FastMix *mix, uint32_t record)
{
    /* what is left over at the end repeats a live triangle, outside the tile */
    *mix = (FastMix){ .record = itg_set((int32_t)record),
                      .at = itg_set((int32_t)fast_at(0, FAST_TILE)),
                      .packed = true };
}

void FAST(mix_add)(FastMix *mix, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth,
                   float *mix_depth)
{
    int to = __builtin_popcount(mix->live);
    for (; live; live &= live - 1, to++) {
        const int lane = __builtin_ctz(live);
        mix->record[to] = (int32_t)record;
        mix->x[to] = x + lane;
        mix->y[to] = y;
        mix->at[to] = (int32_t)fast_at(x + lane, y);
        mix_depth[to] = depth[lane];
    }
    mix->live = (1u << to) - 1;
}

/* --- depth, in and out of the spare row --------------------------------------------------------- */

void FAST(gather_depth)(Tile *tile, const FastMix *mix)
{
    const int count = __builtin_popcount(mix->live);
    for (int i = 0; i < count; i++) {
        tile->depth[fast_at(i, FAST_TILE)] = tile->depth[mix->at[i]];
        tile->stencil[fast_at(i, FAST_TILE)] = tile->stencil[mix->at[i]];
    }
}

void FAST(scatter_depth)(Tile *tile, const FastMix *mix)
{
    const int count = __builtin_popcount(mix->live);
    for (int i = 0; i < count; i++) {
        tile->depth[mix->at[i]] = tile->depth[fast_at(i, FAST_TILE)];
        tile->stencil[mix->at[i]] = tile->stencil[fast_at(i, FAST_TILE)];
    }
}
