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
    /* what is left over at the end repeats a live triangle */
    *mix = (FastMix){ .record = itg_set((int32_t)record), .at = itg_set(-1), .packed = true };
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

/* --- in and out of the spare row ---------------------------------------------------------------- */

static void gather(uint32_t *plane, const FastMix *mix)
{
    uint32_t *spare = plane + fast_at(0, FAST_TILE);
    const int count = __builtin_popcount(mix->live);
    for (int i = 0; i < count; i++)
        spare[i] = plane[mix->at[i]];
}

static void scatter(uint32_t *plane, const FastMix *mix)
{
    const uint32_t *spare = plane + fast_at(0, FAST_TILE);
    const int count = __builtin_popcount(mix->live);
    for (int i = 0; i < count; i++)
        plane[mix->at[i]] = spare[i];
}

static void move_color(Tile *tile, const FastMix *mix, void move(uint32_t *, const FastMix *))
{
    for (int t = 0; t < tile->targets; t++) {
        const GpFormat format = tile->pass->pass->color[t].surface->format;
        const int channels = gp_format_info(format)->channels;
        for (int c = 0; c < (format == GP_A8R8G8B8 ? 1 : channels); c++)
            move((uint32_t *)(void *)tile->planes[t]->channel[c], mix);
    }
}

void FAST(gather_color)(Tile *tile, const FastMix *mix)
{
    move_color(tile, mix, gather);
}

void FAST(scatter_color)(Tile *tile, const FastMix *mix)
{
    move_color(tile, mix, scatter);
}

void FAST(gather_depth)(Tile *tile, const FastMix *mix)
{
    gather(tile->depth, mix);
    for (int i = 0; i < __builtin_popcount(mix->live); i++)
        tile->stencil[fast_at(i, FAST_TILE)] = tile->stencil[mix->at[i]];
}

void FAST(scatter_depth)(Tile *tile, const FastMix *mix)
{
    scatter(tile->depth, mix);
    for (int i = 0; i < __builtin_popcount(mix->live); i++)
        tile->stencil[mix->at[i]] = tile->stencil[fast_at(i, FAST_TILE)];
}
