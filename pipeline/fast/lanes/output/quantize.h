/* What a target makes of a value: the code that is stored, or what reading that back gives. */
#ifndef GP_FAST_OUTPUT_QUANTIZE_H
#define GP_FAST_OUTPUT_QUANTIZE_H

#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/memory/tile.h"

/* To [0, 1], NaN to 0. */
GP_INLINE flt clamped(flt v)
{
    return flt_lesser(flt_greater(v, flt_set(0)), flt_set(1));
}

/* Whether clamping would change anything is seen from the greatest bits of all. */
enum { ONE_BITS = 0x3f800000 }; /* of 1.0f: numbers from 0 to 1 have no greater ones */

GP_INLINE utg greater_bits(utg a, utg b)
{
#ifdef GP_AVX2_LANES
    return (utg)_mm256_max_epu32((__m256i)a, (__m256i)b);
#elif defined GP_AVX512_LANES
    return (utg)_mm512_max_epu32((__m512i)a, (__m512i)b);
#else
    const msk above = (msk)(b > a);
    return (utg)itg_select(above, (itg)b, (itg)a);
#endif
}

/* By twos: they are found while others are, where one after the other would wait for the one before
 * it (layers over words take 8 to 12 % less). */
GP_INLINE utg greatest_bits(const flt v[4])
{
    return greater_bits(greater_bits((utg)v[0], (utg)v[1]), greater_bits((utg)v[2], (utg)v[3]));
}

GP_INLINE flt quantize(GpFormat format, flt v)
{
    switch (format) {
    case GP_A8R8G8B8:
    case GP_R8:
        return flt_quantize_unorm8(clamped(v));
    case GP_G16R16F:
    case GP_A16B16G16R16F:
        return flt_quantize_half(v);
    default:
        return v;
    }
}

/* What a plane of floats holds of a quantized value. */
GP_INLINE itg plane_word(GpFormat format, flt v)
{
    const bool is_whole = format == GP_R32F || format == GP_A32B32G32R32F;
    return is_whole ? canonical((itg)v) : (itg)v; /* halves are, once they are stored */
}

/* The word of A8R8G8B8, of values up to 2. */
GP_INLINE itg word_of(const flt rgba[4])
{
    return itg_pack_unorm8((flt[4]){ rgba[2], rgba[1], rgba[0], rgba[3] });
}

/* The same of any values. */
GP_INLINE itg word_of_any(const flt rgba[4])
{
    flt most[4];
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        most[c] = flt_lesser(flt_set(1), rgba[c]); /* NaN stays, and is stored as 0 */
    return word_of(most);
}

/* Bits of a word in channels that a blend keeps. */
GP_INLINE uint32_t kept_bits(const GpBlend *blend)
{
    static const uint32_t bytes[4] = { 0xff0000, 0xff00, 0xff, 0xff000000 };
    uint32_t kept = 0;
    for (int c = 0; c < 4; c++)
        kept |= blend->keep >> c & 1 ? bytes[c] : 0;
    return kept;
}

enum { RED_BYTE = 2, GREEN_BYTE = 1, BLUE_BYTE = 0, ALPHA_BYTE = 3 };

GP_INLINE void colors_of(itg word, flt rgba[4])
{
    rgba[0] = flt_unpack_unorm8(word, RED_BYTE);
    rgba[1] = flt_unpack_unorm8(word, GREEN_BYTE);
    rgba[2] = flt_unpack_unorm8(word, BLUE_BYTE);
    rgba[3] = flt_unpack_unorm8(word, ALPHA_BYTE);
}

#endif
