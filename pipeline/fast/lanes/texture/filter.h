/* Texels and filters in lanes: each step of pipeline/units/texture.c on all lanes of a packet. */
#ifndef GP_FAST_FILTER_H
#define GP_FAST_FILTER_H

#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/texture/footprint.h"

#include <string.h>

/* Two 16-bit numbers in each lane. */
typedef uint16_t halves __attribute__((vector_size(4 * GP_LANES)));

/* The definition's mix: weights are 256ths, made parts of 1. Both products and the scaling are
 * exact
 * in binary64, so it does not matter that the weights are scaled before and not the sum after. */
GP_INLINE flt lerp(flt a, flt b, itg weight)
{
    dbl part = __builtin_convertvector(flt_from_itg(weight) * (1.0f / ONE), dbl);
    dbl sum =
        __builtin_convertvector(a, dbl) * (1.0 - part) + __builtin_convertvector(b, dbl) * part;
    return flt_select(weight == 0, a, __builtin_convertvector(sum, flt));
}

/* --- texels ----------------------------------------------------------------------------------- */

/* A 16-bit number in each lane; in registers, where as many 32-bit ones would go through memory. */
typedef uint16_t narrow __attribute__((vector_size(2 * GP_LANES)));

/* A byte, or two, for each lane. */
GP_INLINE itg load_narrow(const uint8_t *texels, itg offset, int bytes)
{
    narrow all = { 0 };
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        const uint8_t *texel = texels + offset[lane];
        all[lane] = (uint16_t)(bytes == 1 ? texel[0] : texel[0] | texel[1] << 8);
    }
    return (itg) __builtin_convertvector(all, utg);
}

/* All texels of a format of up to 4 bytes. Where lower ones share the upper ones' addresses,
 * textured fills take 6 % less. */
GP_INLINE void load_words(const FastSampler *s, const Footprint *f, int taps, itg word[4])
{
    if (s->shift == 0 && taps == 4 && f->adjacent) {
        const itg upper = load_narrow(f->texels, f->offset[0], 2);
        const itg lower = load_narrow(f->texels, f->offset[2], 2);
        word[0] = upper & 255;
        word[1] = upper >> 8;
        word[2] = lower & 255;
        word[3] = lower >> 8;
    } else if (s->shift == 0) {
        GP_UNROLL
        for (int i = 0; i < taps; i++)
            word[i] = load_narrow(f->texels, f->offset[i], 1);
    } else if (s->shift == 1) {
        GP_UNROLL
        for (int i = 0; i < taps; i++)
            word[i] = load_narrow(f->texels, f->offset[i], 2);
    } else if (taps == 4 && f->adjacent && f->stacked) {
        itg_gather2(f->texels, f->offset[0], word);
        itg_gather2(f->texels + f->pitch, f->offset[0], word + 2);
    } else if (taps == 4 && f->adjacent) {
        itg_gather2(f->texels, f->offset[0], word);
        itg_gather2(f->texels, f->offset[2], word + 2);
    } else {
        GP_UNROLL
        for (int i = 0; i < taps; i++)
            word[i] = itg_gather(f->texels, f->offset[i]);
    }
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
            rgba[c] = (flt)float_from_half(word[c / 2] & 0xffff);
            rgba[c + 1] = (flt)float_from_half((itg)((utg)word[c / 2] >> 16));
        }
        break;
    case GP_G16R16F:
        word[0] = itg_gather(f->texels, offset);
        rgba[0] = (flt)float_from_half(word[0] & 0xffff);
        rgba[1] = (flt)float_from_half((itg)((utg)word[0] >> 16));
        break;
    case GP_A8R8G8B8_SRGB:
        word[0] = itg_gather(f->texels, offset);
        for (int c = 0; c < 3; c++)
            for (int lane = 0; lane < GP_LANES; lane++)
                rgba[c][lane] = gp_linear_from_srgb8((uint8_t)(word[0][lane] >> (16 - 8 * c)));
        rgba[3] = flt_from_unorm8((itg)((utg)word[0] >> 24));
        break;
    case GP_D16:
        rgba[0] = depth_from_codes(GP_D16, load_narrow(f->texels, offset, 2));
        break;
    case GP_D24S8:
        rgba[0] = depth_from_codes(GP_D24S8, (itg)((utg)itg_gather(f->texels, offset) >> 8));
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

/* Blue and red are the even bytes of an A8R8G8B8 texel, green and alpha the odd ones; R8 and L8
 * have their only channel where blue is. */
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
    if (s->format == GP_A8R8G8B8)
        return;
    rgba[3] = flt_set(1);
    if (s->format == GP_L8)
        rgba[0] = rgba[1] = rgba[2];
    if (s->format == GP_R8) {
        rgba[0] = rgba[2];
        rgba[1] = rgba[2] = flt_set(1);
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

/* Weights are sums of products of 256ths: exact floats. */
GP_INLINE void filter_compare(const FastSampler *s, const Footprint *f, int taps, flt reference,
                              flt rgba[4])
{
    /* as it would be stored (R49) */
    itg code = depth_codes(s->format, math_between(reference, 0.0f, 1.0f)), word[4];
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

#endif
