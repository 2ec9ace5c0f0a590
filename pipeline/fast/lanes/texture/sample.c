/* Texture units side by side: each step of pipeline/units/texture_address.c and pipeline/units/texture.c on all
 * lanes of a packet. Why the results are those of the definition stands where they part. */
#include "pipeline/fast/lanes/memory/tile.h"

#include "pipeline/base/detmath.h"
#include "pipeline/fast/draws/sampler.h"

#include <float.h>
#include <string.h>

enum { ONE = 256 }; /* the whole that weights are parts of */

/* Two 16-bit numbers in each lane. */
typedef uint16_t halves __attribute__((vector_size(4 * GP_LANES)));

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

/* The definition's mix: weights are the halved 256ths. Both products and the scaling are exact in
 * binary64, so it does not matter that the weights are scaled before and not the sum after. */
GP_INLINE flt lerp(flt a, flt b, itg weight)
{
    dbl part = __builtin_convertvector(flt_from_itg(weight) * (1.0f / ONE), dbl);
    dbl sum =
        __builtin_convertvector(a, dbl) * (1.0 - part) + __builtin_convertvector(b, dbl) * part;
    return flt_select(weight == 0, a, __builtin_convertvector(sum, flt));
}

/* --- addressing ------------------------------------------------------------------------------- */

/* R42. The definition cuts clamping modes at 10 sizes; 1.5 give the same texels, since beyond that
 * both texels of the axis are the same one (or the border), whatever their weights: the left of them
 * is at most floor(-1.5 n - 0.5) and the right of them one more, -1 or less, and -n or less when
 * mirrored, for every n >= 1. Numbers stay small enough for nearest_integer at 8192 texels. */
GP_INLINE flt reduce(GpAddress mode, flt coordinate)
{
    /* The remainders are not negative, or a denormal, which is as good as 0: the greater of them and
     * 0 takes care of NaN. */
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
    f->offset[1] = v.at[0] * level->pitch + (u.at[1] << s->shift);
    f->offset[2] = v.at[1] * level->pitch + (u.at[0] << s->shift);
    f->offset[3] = v.at[1] * level->pitch + (u.at[1] << s->shift);
    GP_UNROLL
    for (int i = 1; i < 4; i++)
        f->border[i] = u.outside[i & 1] | v.outside[i >> 1];
}

/* --- texels ----------------------------------------------------------------------------------- */

/* One texel of 1 or 2 bytes for each lane. */
static itg load_narrow(const FastSampler *s, const Footprint *f, int tap)
{
    int32_t offset[GP_LANES], word[GP_LANES];
    itg all;
    memcpy(offset, &f->offset[tap], sizeof offset);
    for (int lane = 0; lane < GP_LANES; lane++) {
        const uint8_t *texel = f->texels + offset[lane];
        word[lane] = s->shift == 0 ? texel[0] : texel[0] | texel[1] << 8;
    }
    memcpy(&all, word, sizeof all);
    return all;
}

/* All texels of a format of up to 4 bytes. */
GP_INLINE void load_words(const FastSampler *s, const Footprint *f, int taps, itg word[4])
{
    if (s->shift < 2) {
        for (int i = 0; i < taps; i++)
            word[i] = load_narrow(s, f, i);
    } else if (taps == 4 && f->adjacent) {
        itg_gather2(f->texels, f->offset[0], word);
        itg_gather2(f->texels, f->offset[2], word + 2);
    } else {
        GP_UNROLL
        for (int i = 0; i < taps; i++)
            word[i] = itg_gather(f->texels, f->offset[i]);
    }
}

/* Halves as gp_float_from_half makes them floats: exact, and any NaN becomes one. */
GP_INLINE flt flt_from_half(itg half)
{
    itg sign = (half & 0x8000) << 16, size = half & 0x7fff;
    itg normal = (size << 13) + (112 << 23);
    itg tiny = (itg)(flt_from_itg(size) * 0x1p-24f);
    itg bits = itg_select(size < 0x400, tiny, normal);
    bits = itg_select(size >= 0x7c00, itg_set(0x7f800000), bits) | sign;
    return (flt)itg_select(size > 0x7c00, itg_set(0x7fc00000), bits);
}

/* One texel for each lane, decoded as gp_texel_load does. */
GP_INLINE void load_floats(const FastSampler *s, const Footprint *f, int tap, flt rgba[4])
{
    const itg offset = f->offset[tap];
    itg word[4];

    rgba[0] = rgba[1] = rgba[2] = rgba[3] = flt_set(1);
    switch (s->format) {
    case GP_A32B32G32R32F:
        itg_gather4(f->texels, offset, word);
        for (int c = 0; c < 4; c++)
            rgba[c] = (flt)word[c];
        break;
    case GP_A16B16G16R16F:
        itg_gather2(f->texels, offset, word);
        for (int c = 0; c < 4; c += 2) {
            rgba[c] = flt_from_half(word[c / 2] & 0xffff);
            rgba[c + 1] = flt_from_half((itg)((utg)word[c / 2] >> 16));
        }
        break;
    case GP_G16R16F:
        word[0] = itg_gather(f->texels, offset);
        rgba[0] = flt_from_half(word[0] & 0xffff);
        rgba[1] = flt_from_half((itg)((utg)word[0] >> 16));
        break;
    case GP_A8R8G8B8_SRGB:
        word[0] = itg_gather(f->texels, offset);
        for (int c = 0; c < 3; c++)
            for (int lane = 0; lane < GP_LANES; lane++)
                rgba[c][lane] = gp_linear_from_srgb8((uint8_t)(word[0][lane] >> (16 - 8 * c)));
        rgba[3] = flt_from_unorm8((itg)((utg)word[0] >> 24));
        break;
    case GP_D16:
        rgba[0] = flt_from_itg(load_narrow(s, f, tap)) / 65535.0f;
        break;
    case GP_D24S8:
        rgba[0] = flt_from_itg((itg)((utg)itg_gather(f->texels, offset) >> 8)) / 16777215.0f;
        break;
    default: /* R32F, D32F */
        rgba[0] = (flt)itg_gather(f->texels, offset);
        break;
    }
    if (s->has_border)
        for (int c = 0; c < 4; c++)
            rgba[c] = flt_select(f->border[tap], flt_set(s->border[c]), rgba[c]);
}

/* --- filters ---------------------------------------------------------------------------------- */

/* Even bytes of a row of the 2x2 texels, or odd ones: two codes in each lane, mixed, times 256. At
 * most 255 * 256, and what is between may wrap. */
GP_INLINE utg lerp_even(itg left, itg right, halves weight)
{
    halves difference = ((halves)right & 255) - ((halves)left & 255);
    return (utg)(((halves)left << 8) + weight * difference);
}

GP_INLINE utg lerp_odd(itg left, itg right, halves weight)
{
    halves difference = ((halves)right >> 8) - ((halves)left >> 8);
    return (utg)(((halves)left & 0xff00) + weight * difference);
}

/* The column: products and sum are integers below 2^24, scaled by 2^-24; so the sum is the
 * definition's of codes and weights, scaled, and the division rounds it once. */
GP_INLINE flt lerp_rows(utg upper, utg lower, flt part_upper, flt part_lower)
{
    flt sum = flt_from_itg((itg)upper) * part_upper + flt_from_itg((itg)lower) * part_lower;
    return sum / (255.0f / ONE);
}

/* Blue and red are the even bytes of an A8R8G8B8 texel, green and alpha the odd ones; R8 has its
 * only channel where blue is. */
GP_INLINE void filter_codes(const FastSampler *s, const Footprint *f, int taps, flt rgba[4])
{
    itg word[4];

    load_words(s, f, taps, word);
    if (s->has_border) {
        GP_UNROLL
        for (int i = 0; i < taps; i++)
            word[i] = itg_select(f->border[i], itg_set((int32_t)s->border_code), word[i]);
    }
    if (taps == 1) {
        rgba[0] = flt_from_unorm8(word[0] >> 16 & 255);
        rgba[1] = flt_from_unorm8(word[0] >> 8 & 255);
        rgba[2] = flt_from_unorm8(word[0] & 255);
        rgba[3] = flt_from_unorm8((itg)((utg)word[0] >> 24));
    } else {
        halves weight = (halves)(f->weight_x | f->weight_x << 16);
        utg even_upper = lerp_even(word[0], word[1], weight);
        utg even_lower = lerp_even(word[2], word[3], weight);
        utg odd_upper = lerp_odd(word[0], word[1], weight);
        utg odd_lower = lerp_odd(word[2], word[3], weight);
        flt lower = flt_from_itg(f->weight_y) * 0x1p-24f;
        flt upper = 0x1p-16f - lower;
        rgba[0] = lerp_rows(even_upper >> 16, even_lower >> 16, upper, lower);
        rgba[1] = lerp_rows(odd_upper & 0xffff, odd_lower & 0xffff, upper, lower);
        rgba[2] = lerp_rows(even_upper & 0xffff, even_lower & 0xffff, upper, lower);
        rgba[3] = lerp_rows(odd_upper >> 16, odd_lower >> 16, upper, lower);
    }
    if (s->format == GP_R8) {
        rgba[0] = rgba[2];
        rgba[1] = rgba[2] = rgba[3] = flt_set(1);
    }
}

/* Channels that the format lacks are 1 in all texels, and so in their mix. */
GP_INLINE void filter_floats(const FastSampler *s, const Footprint *f, int taps, flt rgba[4])
{
    if (taps == 1) {
        load_floats(s, f, 0, rgba);
        return;
    }
    flt texel[4][4];
    for (int i = 0; i < 4; i++)
        load_floats(s, f, i, texel[i]);
    for (int c = 0; c < 4; c++)
        rgba[c] = flt_set(1);
    for (int c = 0; c < s->channels; c++) {
        flt upper = lerp(texel[0][c], texel[1][c], f->weight_x);
        flt lower = lerp(texel[2][c], texel[3][c], f->weight_x);
        rgba[c] = lerp(upper, lower, f->weight_y);
    }
}

/* The reference as it would be stored (R49): a float's bits, or an unorm code, for which R20 wants
 * binary64. The formats' codes are below 2^24. */
GP_INLINE itg store_reference(GpFormat format, flt reference)
{
    flt clamped = math_between(reference, 0.0f, 1.0f);
    if (format == GP_D32F)
        return (itg)clamped;
    double scale = format == GP_D16 ? 65535.0 : 16777215.0;
    flt number = flt_select(clamped == clamped, clamped, flt_set(0));
    return __builtin_convertvector(__builtin_convertvector(number, dbl) * scale + 0.5, itg);
}

/* Weights are sums of products of 256ths: exact floats. */
GP_INLINE void filter_compare(const FastSampler *s, const Footprint *f, int taps, flt reference,
                              flt rgba[4])
{
    itg code = store_reference(s->format, reference), word[4];
    msk passed[4];

    load_words(s, f, taps, word);
    GP_UNROLL
    for (int i = 0; i < taps; i++) {
        if (s->format == GP_D24S8)
            word[i] = (itg)((utg)word[i] >> 8);
        if (s->has_border)
            word[i] = itg_select(f->border[i], itg_set((int32_t)s->border_code), word[i]);
        passed[i] = s->format == GP_D32F ? (flt)code <= (flt)word[i] : code <= word[i];
    }
    itg sum = passed[0] & (ONE * ONE);
    if (taps == 4) {
        itg left = ONE - f->weight_x, right = f->weight_x;
        itg upper = (passed[0] & left) + (passed[1] & right);
        itg lower = (passed[2] & left) + (passed[3] & right);
        sum = (upper << 8) + f->weight_y * (lower - upper);
    }
    rgba[0] = rgba[1] = rgba[2] = rgba[3] = flt_from_itg(sum) * (1.0f / (ONE * ONE));
}

/* --- one level -------------------------------------------------------------------------------- */

GP_INLINE void sample(const FastSampler *s, const FastLevel *level, Variant variant,
                      const float *coord, float *texel)
{
    const int taps = variant.filter == GP_LINEAR ? 4 : 1;
    flt rgba[4];
    Footprint f;
    find_texels(s, level, variant, coord, &f);
    if (variant.sampling == FAST_CODES)
        filter_codes(s, &f, taps, rgba);
    else if (variant.sampling == FAST_FLOATS)
        filter_floats(s, &f, taps, rgba);
    else
        filter_compare(s, &f, taps, flt_load(coord + 2 * GP_LANES), rgba);
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, rgba[c]);
}

/* in   coord: as in GpTextureRead
 * out  texel: likewise */
static void sample_level(const FastSampler *s, const FastLevel *level, GpFilter filter,
                         const float *coord, float *texel)
{
    const GpAddress mode = s->address_u == s->address_v ? s->address_u : ANY_MODE;
    /* clang-format off */
#define SAMPLE(sampling, filter, mode)                                                             \
    sample(s, level, (Variant){ sampling, filter, mode }, coord, texel)
    if (s->sampling == FAST_CODES && filter == GP_LINEAR) {
        if (mode == GP_WRAP)
            SAMPLE(FAST_CODES, GP_LINEAR, GP_WRAP);
        else if (mode == GP_CLAMP)
            SAMPLE(FAST_CODES, GP_LINEAR, GP_CLAMP);
        else
            SAMPLE(FAST_CODES, GP_LINEAR, ANY_MODE);
    } else if (s->sampling == FAST_CODES) {
        SAMPLE(FAST_CODES, GP_POINT, ANY_MODE);
    } else if (s->sampling == FAST_FLOATS) {
        if (filter == GP_LINEAR)
            SAMPLE(FAST_FLOATS, GP_LINEAR, ANY_MODE);
        else
            SAMPLE(FAST_FLOATS, GP_POINT, ANY_MODE);
    } else if (filter == GP_LINEAR) {
        SAMPLE(FAST_COMPARE, GP_LINEAR, ANY_MODE);
    } else {
        SAMPLE(FAST_COMPARE, GP_POINT, ANY_MODE);
    }
#undef SAMPLE
    /* clang-format on */
}

/* --- level of detail -------------------------------------------------------------------------- */

/* gp_texture_lod, from du/dx dv/dx du/dy dv/dy. */
GP_INLINE flt lod_of_gradient(const GpSurface *surface, const flt gradient[4])
{
    const float width = (float)surface->width, height = (float)surface->height;
    flt ux = gradient[0] * width, vx = gradient[1] * height;
    flt uy = gradient[2] * width, vy = gradient[3] * height;
    flt along_x = ux * ux + vx * vx;
    flt along_y = uy * uy + vy * vy;
    flt longer = flt_lesser(flt_greater(along_x, along_y), flt_set(FLT_MAX));
    msk numbers = (along_x == along_x) & (along_y == along_y);
    return flt_select(numbers, 0.5f * math_log2_of_size(longer, -__builtin_inff()), flt_set(0));
}

GP_INLINE flt find_lod(const GpSurface *surface, const GpTextureRead *read)
{
    flt gradient[4], u = flt_load(read->coord), v = flt_load(read->coord + GP_LANES);
    flt w = flt_load(read->coord + 3 * GP_LANES);
    if (read->mode == GP_LOD_EXPLICIT)
        return w;
    if (read->mode == GP_LOD_GRADIENT) {
        for (int i = 0; i < 4; i++)
            gradient[i] = flt_load(read->gradient + i * GP_LANES);
    } else {
        gradient[0] = flt_quad_dx(u);
        gradient[1] = flt_quad_dx(v);
        gradient[2] = flt_quad_dy(u);
        gradient[3] = flt_quad_dy(v);
    }
    flt lod = lod_of_gradient(surface, gradient);
    return read->mode == GP_LOD_BIAS ? lod + w : lod;
}

/* Bias and bounds of R44. */
GP_INLINE flt bias_lod(const FastSampler *s, flt lod)
{
    flt biased = lod + s->lod_bias;
    biased = flt_select(biased == biased, biased, flt_set(0));
    if (s->max_lod != 0.0f)
        biased = flt_select(biased > s->max_lod, flt_set(s->max_lod), biased);
    return flt_select(biased < s->min_lod, flt_set(s->min_lod), biased);
}

/* One level after the other: each is sampled once, for the lanes that use it as their finer level
 * and for those that use it as their coarser one. What is sampled for the other lanes is lost. */
static void sample_mixed_levels(const FastSampler *s, itg first, itg weight, GpFilter filter,
                                const float *coord, flt fine[4], flt coarse[4])
{
    uint32_t used = 0; /* bit i: level i */
    for (int lane = 0; lane < GP_LANES; lane++)
        used |= (weight[lane] ? 3u : 1u) << first[lane];

    for (int c = 0; c < 4; c++)
        fine[c] = coarse[c] = flt_set(0);
    for (int32_t number = 0; used >> number; number++) {
        flt texel[4];
        if (!(used >> number & 1u))
            continue;
        sample_level(s, &s->levels[number], filter, coord, (float *)texel);
        for (int c = 0; c < 4; c++) {
            fine[c] = flt_select(first == number, texel[c], fine[c]);
            coarse[c] = flt_select(first + 1 == number, texel[c], coarse[c]);
        }
    }
}

static void sample_levels(const FastSampler *s, flt lod, GpFilter filter, const float *coord,
                          float *texel)
{
    const int32_t last = (int32_t)(s->surface->levels - 1) * ONE;
    const bool blend = s->mip == GP_MIP_LINEAR;
    itg detail = nearest_integer(math_between(lod, -128.0f, 128.0f - 1.0f / ONE) * (float)ONE);
    detail = itg_greater(itg_lesser(detail, itg_set(last)), itg_set(0));
    itg first = (blend ? detail : detail + ONE / 2) >> 8;
    itg weight = blend ? detail & (ONE - 1) : itg_set(0);

    /* Mostly the same levels serve all lanes. Counting up to the finest lets the processor guess
     * it and go on, where taking it from `first` would wait for the logarithm. */
    flt fine[4], coarse[4];
    int32_t number = 0;
    while (!msk_bits(first == number))
        number++;
    if (!msk_bits(first != number)) {
        if (!msk_bits(weight != 0)) {
            sample_level(s, &s->levels[number], filter, coord, texel);
            return;
        }
        sample_level(s, &s->levels[number], filter, coord, (float *)fine);
        sample_level(s, &s->levels[number + 1], filter, coord, (float *)coarse);
    } else {
        sample_mixed_levels(s, first, weight, filter, coord, fine, coarse);
    }
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, lerp(fine[c], coarse[c], weight));
}

static void sample_filtered(const FastSampler *s, flt lod, GpFilter filter, const float *coord,
                            float *texel)
{
    if (s->mip == GP_MIP_NONE)
        sample_level(s, &s->levels[s->level], filter, coord, texel);
    else
        sample_levels(s, lod, filter, coord, texel);
}

/* Where filters differ, and some lanes magnify while others do not, all are sampled both ways. */
static void sample_by_lod(const FastSampler *s, const GpTextureRead *read)
{
    flt lod = bias_lod(s, find_lod(s->surface, read));
    msk minified = lod > 0.0f;

    if (s->min == s->mag || !msk_bits(~minified)) {
        sample_filtered(s, lod, s->min, read->coord, read->texel);
        return;
    }
    flt texel[4];
    sample_filtered(s, lod, s->mag, read->coord, read->texel);
    if (!msk_bits(minified))
        return;
    sample_filtered(s, lod, s->min, read->coord, (float *)texel);
    for (int c = 0; c < 4; c++) {
        float *to = read->texel + c * GP_LANES;
        flt_store(to, flt_select(minified, texel[c], flt_load(to)));
    }
}

void fast_read_texture(const GpShaderCall *call, const GpTextureRead *read)
{
    const FastSampler *s = (const FastSampler *)call->executor + read->slot;

    GP_ASSERT(read->lanes == GP_LANES);
    if (s->sampling == FAST_UNBOUND)
        for (int c = 0; c < 4; c++)
            flt_store(read->texel + c * GP_LANES, flt_set(c == 3));
    else if (s->one_level)
        sample_level(s, &s->levels[s->level], s->min, read->coord, read->texel);
    else
        sample_by_lod(s, read);
}
