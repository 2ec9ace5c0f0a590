/* The farthest depths of the tile's parts: a triangle behind all of them need not be set up. They
 * may be old, since under the usual tests depths only come nearer. */
#ifndef GP_FAST_RASTER_HIERARCHICAL_DEPTH_H
#define GP_FAST_RASTER_HIERARCHICAL_DEPTH_H

#include "pipeline/fast/lanes/raster/fragment_path.h"

/* Pixels a side. Each entry is for a window of two by two blocks, which has room for a small box
 * wherever in the first one it begins. */
enum { FARTHEST_BLOCK = 8, FARTHEST_BITS = 3 };

/* Before a draw, or where there is no next one before a pass: forgets the depths where they may
 * come to be farther. */
void FAST(keep_farthest)(Tile *tile, const FastDraw *next);

/* Looks at all of the tile's depths. */
void FAST(find_farthest)(Tile *tile);

/* Before `count` triangles are filled: the same where it is worth it. */
GP_INLINE void renew_farthest(Tile *tile, uint32_t count)
{
    enum { WORTH_IT = 128 };
    if (tile->filled >= WORTH_IT)
        FAST(find_farthest)(tile);
    tile->filled += count;
}

/* Boxes in the tile, of `drawn` lanes, none of whose pixels passes the usual test if no depth in
 * them is below `nearest`. */
GP_INLINE unsigned hidden_boxes(const Filler *f, unsigned drawn, itg x, itg y, itg width,
                                itg height, flt nearest)
{
    const itg column = x >> FARTHEST_BITS, row = y >> FARTHEST_BITS;
    const itg wide = ((x + width) >> FARTHEST_BITS) - column;
    const itg high = ((y + height) >> FARTHEST_BITS) - row;
    const itg entry = (row * (FAST_TILE / FARTHEST_BLOCK) + column) & mask_of(drawn);
    const itg farthest =
        itg_gather((const uint8_t *)f->tile->farthest, entry * (int)sizeof(int32_t));
    const itg code = nearer_codes(f, f->early, nearest);
    return drawn & msk_bits((msk)(code - f->allowance >= farthest) & (msk)((wide | high) < 2));
}

#endif
