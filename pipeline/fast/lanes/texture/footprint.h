/* Addressing in lanes: each step of pipeline/units/texture_address.c on all lanes of a packet. */
#ifndef GP_FAST_FOOTPRINT_H
#define GP_FAST_FOOTPRINT_H

#include "pipeline/base/detmath.h"
#include "pipeline/fast/draws/sampler.h"
#include "pipeline/fast/lanes/memory/tile.h"

enum { ONE = 256 }; /* the whole that weights are parts of */

/* What a read is compiled for: several kinds have code of their own, with these as constants. */
typedef struct Variant {
    FastSampling sampling;
    GpFilter filter;
    GpAddress mode; /* of both axes; ANY_MODE: as the sampler says */
} Variant;

static const GpAddress ANY_MODE = GP_ADDRESSES;

/* The two texels of one axis. */
typedef struct Axis {
    itg at[2];  /* inside the level also where the border counts */
    itg weight; /* of at[1], in 256ths */
    msk outside[2];
} Axis;

/* The 2x2 texels of each lane: top left, top right, bottom left, bottom right; the first alone for
 * point filtering. */
typedef struct Footprint {
    const uint8_t *texels;
    bool adjacent; /* in all lanes right texels lie directly behind left ones in memory */
    bool stacked; /* and lower ones a pitch behind upper ones: looked at where it saves addresses */
    int32_t pitch;
    itg offset[4]; /* bytes */
    msk border[4]; /* meaningful where the sampler has one */
    itg weight_x, weight_y;
} Footprint;

/* --- small arithmetic ------------------------------------------------------------------------- */

/* Added to a float of at most 2^22 makes its low bits the integer nearest to it, ties to even: the
 * sum lies in [2^23, 2^24], where neighbours are 1 apart, and rounds once, as the definition's in
 * binary64 does. */
#define ROUND_TO_INTEGER 0x1.8p23f
enum { ROUND_BITS = 0x4b400000 };

GP_INLINE itg nearest_integer(flt value)
{
    return (itg)(value + ROUND_TO_INTEGER) - ROUND_BITS;
}

/* --- addressing ------------------------------------------------------------------------------- */

/* R42. The definition cuts clamping modes at 10 sizes; 1.5 give the same texels, since beyond that
 * both texels of the axis are the same one (or the border), whatever their weights: the left of
 * them is at most floor(-1.5 n - 0.5) and the right of them one more, -1 or less, and -n or less
 * when mirrored, for every n >= 1. Numbers stay small enough for nearest_integer at 8192 texels. */
GP_INLINE flt reduce(GpAddress mode, flt coordinate)
{
    /* The remainders are not negative, or a denormal, which is as good as 0: the greater of them
     * and 0 takes care of NaN. */
    if (mode == GP_WRAP)
        return flt_greater(coordinate - flt_floor(coordinate), flt_set(0));
    if (mode == GP_MIRROR)
        return flt_greater(coordinate - 2.0f * flt_floor(0.5f * coordinate), flt_set(0));
    flt reduced = math_between(coordinate, -1.5f, 1.5f);
    return flt_select(reduced == reduced, reduced, flt_set(0));
}

/* The definition rounds the product, subtracts 1/2, rounds, and multiplies by 256; here all are 256
 * times as large from the start, which changes no rounding. (Products too small to be normal round
 * otherwise, but all such positions are 0.) Then R41; reduce leaves numbers between -1 and n for
 * wrap, 2n for mirror, so that one step does for the remainder. */
GP_INLINE void find_axis(GpAddress mode, GpFilter filter, flt coordinate, float scale, int32_t n,
                         Axis *axis)
{
    flt position = reduce(mode, coordinate) * scale;
    itg fixed = nearest_integer(filter == GP_LINEAR ? position - 128.0f : position);
    itg first = fixed >> 8, second = first + 1;

    axis->weight = fixed & (ONE - 1);
    axis->outside[0] = axis->outside[1] = itg_set(0);
    if (mode == GP_WRAP) {
        axis->at[0] = filter == GP_LINEAR ? first + (first >> 31 & n) : first & ~(first == n);
        axis->at[1] = second & ~(second == n);
        return;
    }
    if (mode == GP_BORDER) {
        axis->outside[0] = (first < 0) | (first >= n);
        axis->outside[1] = (second < 0) | (second >= n);
    } else if (mode == GP_MIRROR) { /* 2n, and -1 too, is 0 again: cut below */
        first = itg_lesser(first, 2 * n - 1 - first);
        second = itg_lesser(second, 2 * n - 1 - second);
    } else if (mode == GP_MIRROR_ONCE) { /* -index - 1 where negative */
        first ^= first >> 31;
        second ^= second >> 31;
    }
    axis->at[0] = itg_greater(itg_lesser(first, itg_set(n - 1)), itg_set(0));
    axis->at[1] = itg_greater(itg_lesser(second, itg_set(n - 1)), itg_set(0));
}

/* The same by the sampler's own mode; inlined, there is one jump and straight code behind it. */
GP_INLINE void find_any_axis(GpAddress mode, GpFilter filter, flt coordinate, float scale,
                             int32_t n, Axis *axis)
{
    if (mode == GP_WRAP)
        find_axis(GP_WRAP, filter, coordinate, scale, n, axis);
    else if (mode == GP_CLAMP)
        find_axis(GP_CLAMP, filter, coordinate, scale, n, axis);
    else if (mode == GP_BORDER)
        find_axis(GP_BORDER, filter, coordinate, scale, n, axis);
    else if (mode == GP_MIRROR)
        find_axis(GP_MIRROR, filter, coordinate, scale, n, axis);
    else
        find_axis(GP_MIRROR_ONCE, filter, coordinate, scale, n, axis);
}

GP_INLINE void find_texels(const FastSampler *s, const FastLevel *level, Variant variant,
                           const float *coord, Footprint *f)
{
    flt x = flt_load(coord), y = flt_load(coord + GP_LANES);
    Axis u, v;
    if (variant.mode == ANY_MODE) {
        find_any_axis(s->address_u, variant.filter, x, level->scale_u, level->width, &u);
        find_any_axis(s->address_v, variant.filter, y, level->scale_v, level->height, &v);
    } else {
        find_axis(variant.mode, variant.filter, x, level->scale_u, level->width, &u);
        find_axis(variant.mode, variant.filter, y, level->scale_v, level->height, &v);
    }

    f->texels = level->texels;
    f->offset[0] = v.at[0] * level->pitch + (u.at[0] << s->shift);
    f->border[0] = u.outside[0] | v.outside[0];
    if (variant.filter == GP_POINT)
        return;
    f->weight_x = u.weight;
    f->weight_y = v.weight;
    f->adjacent = !msk_bits(u.at[1] - u.at[0] != 1);
    f->stacked = GATHERS_BY_LANE && !msk_bits(v.at[1] - v.at[0] != 1);
    f->pitch = level->pitch;
    f->offset[1] = v.at[0] * level->pitch + (u.at[1] << s->shift);
    f->offset[2] = v.at[1] * level->pitch + (u.at[0] << s->shift);
    f->offset[3] = v.at[1] * level->pitch + (u.at[1] << s->shift);
    GP_UNROLL
    for (int i = 1; i < 4; i++)
        f->border[i] = u.outside[i & 1] | v.outside[i >> 1];
}

#endif
