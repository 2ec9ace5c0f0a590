/* The hierarchical depth of the tile's parts: a triangle behind all of them need not be set up.
 * They may be old, since under the usual tests depths only come nearer. */
#ifndef GP_FAST_RASTER_HIERARCHICAL_DEPTH_H
#define GP_FAST_RASTER_HIERARCHICAL_DEPTH_H

#include "pipeline/fast/lanes/raster/fragment_path.h"

/* Pixels a side. Each entry is for a window of two by two blocks, which has room for a small box
 * wherever in the first one it begins. */
enum {
    DEPTH_BLOCK = 8,
    DEPTH_BLOCK_BITS = 3,
    FAST_DEPTH_WINDOWS = FAST_TILE * FAST_TILE / 64 < 16 ? 16 : FAST_TILE * FAST_TILE / 64,
};

/* Of each window the farthest depth that is stored, as a code. */
typedef struct FastHierarchicalDepth {
    _Alignas(64) int32_t farthest[FAST_DEPTH_WINDOWS];
    uint32_t filled; /* triangles, since it was found */
} FastHierarchicalDepth;

/* Before a draw, or where there is no next one before a pass: forgets the depths where they may
 * come to be farther. */
void fast_keep_hierarchical_depth(Tile *tile, const FastDraw *next);

/* Looks at all of the tile's depths. */
void fast_find_hierarchical_depth(Tile *tile);

/* Before `count` triangles are filled: the same where it is worth it. */
GP_INLINE void renew_hierarchical_depth(Tile *tile, uint32_t count)
{
    enum { WORTH_IT = 128 };
    if (tile->hierarchical_depth->filled >= WORTH_IT)
        fast_find_hierarchical_depth(tile);
    tile->hierarchical_depth->filled += count;
}

/* Boxes in the tile, of `drawn` lanes, none of whose pixels passes the usual test if no depth in
 * them is below `nearest`. */
GP_INLINE unsigned occluded_boxes(const Filler *f, unsigned drawn, itg x, itg y, itg width,
                                  itg height, flt nearest)
{
    const itg column = x >> DEPTH_BLOCK_BITS, row = y >> DEPTH_BLOCK_BITS;
    const itg wide = ((x + width) >> DEPTH_BLOCK_BITS) - column;
    const itg high = ((y + height) >> DEPTH_BLOCK_BITS) - row;
    const itg entry = (row * (FAST_TILE / DEPTH_BLOCK) + column) & mask_of(drawn);
    const itg bound = itg_gather((const uint8_t *)f->tile->hierarchical_depth->farthest,
                                 entry * (int)sizeof(int32_t));
    const itg code = nearer_codes(f, f->early, nearest);
    return drawn & msk_bits((msk)(code - f->allowance >= bound) & (msk)((wide | high) < 2));
}

#endif
