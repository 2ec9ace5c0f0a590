#include "pipeline/fast/lanes/raster/hierarchical_depth.h"

enum { SIDE = FAST_TILE / DEPTH_BLOCK };

static bool only_nears(const FastDraw *d)
{
    const GpCompare test = d->draw->state.depth.test;
    return !d->wants_depth || test == GP_LESS || test == GP_LESS_EQUAL;
}

void fast_keep_hierarchical_depth(Tile *tile, const FastDraw *next)
{
    if (next && only_nears(next))
        return;
    for (int i = 0; i < FAST_DEPTH_WINDOWS; i++)
        tile->hierarchical_depth->farthest[i] = INT32_MAX;
    tile->hierarchical_depth->filled = 0;
}

/* Down the columns of each row of blocks. */
static void find_columns(const uint32_t *depth, int32_t columns[SIDE * FAST_TILE])
{
    for (int32_t row = 0; row < SIDE; row++, depth += DEPTH_BLOCK * FAST_PITCH)
        for (int32_t x = 0; x < FAST_TILE; x += GP_LANES) {
            itg most = itg_set(0);
            GP_UNROLL
            for (int32_t y = 0; y < DEPTH_BLOCK; y++)
                most = itg_greater(most, load_lanes(depth + fast_at(x, y), false));
            __builtin_memcpy(&columns[row * FAST_TILE + x], &most, sizeof most);
        }
}

/* The greater of every two neighbours. */
static void halve(int32_t *codes, int32_t count)
{
    for (int32_t i = 0; i < count / 2; i += GP_LANES) {
        itg first, second;
        __builtin_memcpy(&first, &codes[2 * i], sizeof first);
        __builtin_memcpy(&second, &codes[2 * i + GP_LANES], sizeof second);
        first = itg_greater(itg_evens(first, second), itg_odds(first, second));
        __builtin_memcpy(&codes[i], &first, sizeof first);
    }
}

/* What lies past the tile's last block belongs to no box. */
void fast_find_hierarchical_depth(Tile *tile)
{
    _Alignas(64) int32_t block[SIDE * FAST_TILE];
    find_columns(tile->depth, block);
    for (int32_t wide = 1; wide < DEPTH_BLOCK; wide *= 2)
        halve(block, SIDE * FAST_TILE / wide);
    for (int32_t i = 0; i < SIDE * SIDE; i += GP_LANES) {
        itg most = itg_set(0);
        GP_UNROLL
        for (int32_t corner = 0; corner < 4; corner++) {
            itg one;
            __builtin_memcpy(&one, &block[i + (corner & 1) + (corner >> 1) * SIDE], sizeof one);
            most = itg_greater(most, one);
        }
        __builtin_memcpy(&tile->hierarchical_depth->farthest[i], &most, sizeof most);
    }
    tile->hierarchical_depth->filled = 0;
}
