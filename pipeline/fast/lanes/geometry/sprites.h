/* Point sprites in lanes: the arithmetic of gp_setup_point. */
#ifndef GP_FAST_SPRITES_H
#define GP_FAST_SPRITES_H

#include "pipeline/fast/lanes/memory/tile.h"

/* The sprites of GP_LANES points. */
typedef struct Sprites {
    itg left, top, whole; /* 24.8 fixed point: corner and side */
    itg x0, y0, x1, y1;   /* pixels, ends included */
    flt z;
    unsigned drawn; /* bit i: sprite i has pixels in the rectangle */
} Sprites;

/* Batches that are shaded at once, where varyings are not kept. */
enum { FAST_SPRITE_BATCHES = 4 };

/* Sprites in one tile: boxes from its first pixel on, corners from that pixel's centre on. */
typedef struct SpriteBatch {
    Sprites at;
    flt per_step;              /* 1 over the side in sub-pixels */
    uint32_t vertex[GP_LANES]; /* rising, where no index names it */
} SpriteBatch;

/* The first pixel whose centre is at or right of (below) a coordinate. */
GP_INLINE itg first_center(itg fixed)
{
    return (fixed + (GP_SUBPIXELS / 2 - 1)) >> GP_SUBPIXEL_BITS;
}

/* Sprites of a draw's vertices, which are counted from its first. */
GP_INLINE Sprites place_sprites(const FastDraw *d, const uint32_t vertex[GP_LANES],
                                const GpRect *rect)
{
    const void *record[GP_LANES];
    itg position[4];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        record[lane] = &d->positions[vertex[lane]];
    lanes_load4(record, position);

    Sprites s;
    s.z = (flt)position[2];
    flt size = (flt)position[3];
    const flt most = flt_set((float)GP_MAX_POINT_SIZE);
    size = flt_select((msk)(size > 0.0f), size, flt_set(0)); /* NaN to 0 */
    size = flt_select((msk)(size < most), size, most);
    /* to nearest even, as gp_snap: adding 2^23 leaves no place for a fraction */
    s.whole = itg_from_flt((size * (float)GP_SUBPIXELS + 0x1p23f) - 0x1p23f);
    s.left = position[0] - (s.whole >> 1);
    s.top = position[1] - (s.whole >> 1);
    s.x0 = itg_greater(first_center(s.left), itg_set(rect->x0));
    s.y0 = itg_greater(first_center(s.top), itg_set(rect->y0));
    s.x1 = itg_lesser(first_center(s.left + s.whole), itg_set(rect->x1)) - 1;
    s.y1 = itg_lesser(first_center(s.top + s.whole), itg_set(rect->y1)) - 1;
    s.drawn = msk_bits((msk)(s.whole > 0) & (msk)(s.x0 <= s.x1) & (msk)(s.y0 <= s.y1));
    return s;
}

#endif
