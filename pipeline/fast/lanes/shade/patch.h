/* Where the lanes of a patch are. */
#ifndef GP_FAST_PATCH_H
#define GP_FAST_PATCH_H

#include "pipeline/fast/lanes/quads.h"

enum {
    ALL_LANES = (1 << GP_LANES) - 1,
    QUADS_WIDE = GP_LANES / 2, /* pixels across a patch of quads */
};

/* Field by field: a patch put together elsewhere would be stored in bytes and copied in words, for
 * which a processor must wait. */
GP_INLINE void set_patch(FastPatch *patch, uint32_t record, int32_t x, int32_t y, unsigned live,
                         int32_t wide)
{
    patch->record = record;
    patch->live = live;
    patch->x = (uint8_t)x;
    patch->y = (uint8_t)y;
    patch->wide = (uint8_t)wide;
    patch->mixed = false;
}

/* Row of each lane where rows are `wide` pixels: lane / wide. Times 256 / wide and a bit more is the
 * same up to lane 15. */
GP_INLINE itg lane_row(int32_t wide)
{
    static const uint16_t share[17] = { 0,  257, 129, 86, 65, 52, 43, 37, 33,
                                        29, 26,  24,  22, 20, 19, 18, 17 };
    return lane_numbers() * share[wide] >> 8;
}

/* Of each lane, from the patch's first pixel; `wide` as in FastPatch. Most are whole rows. */
GP_INLINE itg patch_columns(int32_t wide)
{
    if (!wide || wide == GP_LANES)
        return lane_columns(!wide);
    return lane_numbers() - lane_row(wide) * wide;
}

GP_INLINE itg patch_rows(int32_t wide)
{
    if (!wide || wide == GP_LANES)
        return lane_rows(!wide);
    return lane_row(wide);
}

GP_INLINE itg patch_x(const FastPatch *patch)
{
    return patch->x + patch_columns(patch->wide);
}

GP_INLINE itg patch_y(const FastPatch *patch)
{
    return patch->y + patch_rows(patch->wide);
}

/* Whether row r of a patch of rows has pixels that live. */
GP_INLINE bool has_row(const FastPatch *patch, int r)
{
    return r * patch->wide < GP_LANES && patch->live >> r * patch->wide;
}

/* The words of a plane under a patch; of its pixels that live, at least. Row r of a patch of rows is
 * found in its lanes when the load starts so many lanes further left. */
GP_INLINE itg load_patch(const void *plane, const FastPatch *patch)
{
    const uint32_t *from = (const uint32_t *)plane + fast_at(patch->x, patch->y);
    itg words = load_lanes(from, !patch->wide);
    if (!patch->wide || patch->wide == GP_LANES)
        return words;
    const itg row = lane_row(patch->wide);
    for (int r = 1; has_row(patch, r); r++) {
        from += FAST_PITCH - patch->wide;
        words = itg_select((msk)(row == r), load_lanes(from, false), words);
    }
    return words;
}

GP_INLINE void store_patch(void *plane, const FastPatch *patch, unsigned live, itg words)
{
    uint32_t *to = (uint32_t *)plane + fast_at(patch->x, patch->y);
    if (!patch->wide || patch->wide == GP_LANES) {
        if (live != ALL_LANES)
            words = itg_select(mask_of(live), words, load_lanes(to, !patch->wide));
        store_lanes(to, !patch->wide, words);
        return;
    }
    const itg row = lane_row(patch->wide), alive = mask_of(live);
    for (int r = 0; has_row(patch, r); r++, to += FAST_PITCH - patch->wide)
        store_lanes(to, false, itg_select((msk)(row == r) & alive, words, load_lanes(to, false)));
}

/* Depth and stencil of a patch.
 * in      z: not clamped
 * returns the lanes of `live` that pass */
unsigned FAST(test_patch)(Tile *tile, const FastDraw *draw, const FastPatch *patch, unsigned live,
                          flt z);

/* An edge function in this tile, in 32 bits, in units of `unit`, a power of two. */
typedef struct Edge {
    int32_t c, a, b;
    float unit;
} Edge;

/* Room at the end of the queue. */
FastPatch *FAST(new_patch)(Tile *tile);

/* False where the edge needs more bits. */
bool FAST(narrow_edge)(const FastWide *wide, int i, Edge *edge);

/* Shades patches whose inputs are there. */
void FAST(shade_inputs)(Tile *tile, const FastDraw *draw, const FastPatch *patches, int count,
                        const float *depths);

#endif
