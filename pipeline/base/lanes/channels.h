/* Lanes to and from the channels of texels: 8-bit codes and halves. */
#ifndef GP_LANES_CHANNELS_H
#define GP_LANES_CHANNELS_H

#include "pipeline/base/lanes/arithmetic.h"

#if defined GP_AVX512_LANES || (defined GP_AVX2_LANES && defined __FMA__)
#define GP_FUSED_LANES 1
/* a b + c, rounded once. */
GP_INLINE flt flt_fused(flt a, float b, flt c)
{
    return (flt)GP_NATIVE(fmadd_ps)((gp_native_flt)a, (gp_native_flt)flt_set(b), (gp_native_flt)c);
}

/* 2^23 + floor(255 v + 0.5), for v from 0 to 2: there floats have no room for fractions, and
 * rounded once only v = 1/2, whose code is even, lies half-way between two. */
GP_INLINE itg itg_unorm8_above(flt v)
{
    return (itg)flt_fused(v, 255.0f, flt_set(0x1p23f));
}
#endif

/* code / 255 for whole numbers of 0 to 255, correctly rounded (R23), without the division: 1/255 is
 * (1 + 1/255) / 256, and the second product, which is small, may be a little wrong. */
GP_INLINE flt flt_from_unorm8(itg code)
{
    flt number = flt_from_itg(code);
#ifdef GP_FUSED_LANES
    return flt_fused(number, 0x1.010102p-16f, number * 0x1p-8f);
#else
    return number * 0x1p-8f + number * 0x1.010102p-16f;
#endif
}

/* The code of an 8-bit channel (R24), floor(255 v + 0.5), for v from 0 to 1: in units of about
 * 2^-25, where 255 v is 256 m - m. The factor is a shade below 2^25, with which the floats on both
 * sides of each of the 255 bounds go the right way (tests/kernel/check_channels.c); the rest
 * follows, since every step keeps the order. */
GP_INLINE itg itg_unorm8(flt v)
{
#ifdef GP_FUSED_LANES
    return itg_unorm8_above(v) & 255;
#else
    itg m = itg_from_flt(v * 0x1.fffffep24f);
    return (m + (1 << 16) - (m >> 8)) >> 17;
#endif
}

/* Words whose byte i, from the lowest, is the code of v[i]: up to 2, those above 1 as 1; negative
 * ones and NaN as 0. Or the average of 0 and floor(510 v), which averaging rounds up; rounded
 * toward zero no product reaches a whole number from below. */
GP_INLINE itg itg_pack_unorm8(const flt v[4])
{
#ifdef GP_AVX512_LANES
    enum { TO_ZERO = _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC };
    __m512i twice[4];
    GP_UNROLL
    for (int i = 0; i < 4; i++) /* of NaN the least integer */
        twice[i] =
            _mm512_cvttps_epi32(_mm512_mul_round_ps((__m512)v[i], _mm512_set1_ps(510.0f), TO_ZERO));
    __m512i zero = _mm512_setzero_si512();
    __m512i low = _mm512_avg_epu16(_mm512_packus_epi32(twice[0], twice[1]), zero);
    __m512i high = _mm512_avg_epu16(_mm512_packus_epi32(twice[2], twice[3]), zero);
    __m128i by_pixel = _mm_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
    return (itg)_mm512_shuffle_epi8(_mm512_packus_epi16(low, high),
                                    _mm512_broadcast_i32x4(by_pixel));
#elif defined GP_FUSED_LANES
    __m256i above[4]; /* of NaN the code is 0, as max is defined */
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        above[i] = (__m256i)itg_unorm8_above(flt_greater(v[i], flt_set(0)));
    __m256i low = _mm256_blend_epi16(above[0], _mm256_slli_epi32(above[1], 16), 0xaa);
    __m256i high = _mm256_blend_epi16(above[2], _mm256_slli_epi32(above[3], 16), 0xaa);
    __m128i by_pixel = _mm_setr_epi8(0, 1, 8, 9, 2, 3, 10, 11, 4, 5, 12, 13, 6, 7, 14, 15);
    return (itg)_mm256_shuffle_epi8(_mm256_packus_epi16(low, high),
                                    _mm256_broadcastsi128_si256(by_pixel));
#else
    itg word = itg_set(0);
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        word |= itg_unorm8(flt_lesser(flt_greater(v[i], flt_set(0)), flt_set(1))) << 8 * i;
    return word;
#endif
}

/* Byte i of each word as code / 255, correctly rounded (R23). Written to base 256 the quotient is
 * 0.ccc...; the first bit that 24 cannot hold is c's own leading one, so it is always rounded
 * up. */
GP_INLINE flt flt_unpack_unorm8(itg word, int i)
{
#ifdef GP_AVX512_LANES
    enum { UP = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC };
    __m128i repeated = _mm_set_epi32(0x0c0c0c0c, 0x08080808, 0x04040404, 0);
    repeated = _mm_add_epi32(repeated, _mm_set1_epi32(i * 0x01010101));
    __m512i cccc = _mm512_shuffle_epi8((__m512i)word, _mm512_broadcast_i32x4(repeated));
    return (flt)_mm512_cvt_roundepu32_ps(cccc, UP) * 0x1p-32f;
#else
    return flt_from_unorm8((itg)((utg)word >> 8 * i & 255));
#endif
}

/* The value that a store and a load of an 8-bit channel leave (R23, R24), for v from 0 to 1. Behind
 * 2^15 a float has room for code / 256 and no more. The rest is flt_from_unorm8. */
GP_INLINE flt flt_quantize_unorm8(flt v)
{
#ifdef GP_FUSED_LANES
    flt code = flt_fused(v, 255.0f / 256.0f, flt_set(0x1p15f)) - 0x1p15f;
    return flt_fused(code, 0x1.010102p-8f, code);
#else
    return flt_from_unorm8(itg_unorm8(v));
#endif
}

/* a + b by the units that multiply: rounding to halves, which goes before and after, keeps those
 * that add busy. */
GP_INLINE flt flt_sum_between_halves(flt a, flt b)
{
#ifdef GP_FUSED_LANES
    return flt_fused(a, 1.0f, b);
#else
    return a + b;
#endif
}

/* The value that a store and a load of a half leave (R27); of a NaN its upper bits, quiet. */
GP_INLINE flt flt_quantize_half(flt v)
{
#ifdef GP_AVX512_LANES
    enum { NEAREST = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC };
    return (flt)_mm512_cvtph_ps(_mm512_maskz_cvtps_ph(0xffff, (__m512)v, NEAREST)); /* all lanes */
#elif defined GP_AVX2_LANES && defined __F16C__
    return (flt)_mm256_cvtph_ps(_mm256_cvtps_ph((__m256)v, _MM_FROUND_TO_NEAREST_INT));
#else
    itg bits = (itg)v, sign = bits & INT32_MIN, size = bits & 0x7fffffff;
    itg normal = (size + 0xfff + (size >> 13 & 1)) & ~0x1fff;
    itg small = (itg)(((flt)size + 0.5f) - 0.5f);
    itg rounded = itg_select((msk)(size < 0x38800000), small, normal);
    rounded = itg_select((msk)(size >= 0x477ff000), itg_set(0x7f800000), rounded);
    itg quiet = (size | 0x00400000) & ~0x1fff;
    return (flt)(sign | itg_select((msk)(size > 0x7f800000), quiet, rounded));
#endif
}

/* The same of four, whatever the width of lanes. */
GP_INLINE flt4 flt4_quantize_half(flt4 v)
{
#if defined GP_X86_LANES && defined __F16C__
    return (flt4)_mm_cvtph_ps(_mm_cvtps_ph((__m128)v, _MM_FROUND_TO_NEAREST_INT));
#else
    flt all = flt_set(0);
    __builtin_memcpy(&all, &v, sizeof v);
    all = flt_quantize_half(all);
    __builtin_memcpy(&v, &all, sizeof v);
    return v;
#endif
}

#if GP_LANES >= 8
/* The same of eight. */
GP_INLINE flt8 flt8_quantize_half(flt8 v)
{
#if defined GP_X86_LANES && defined __F16C__
    return (flt8)_mm256_cvtph_ps(_mm256_cvtps_ph((__m256)v, _MM_FROUND_TO_NEAREST_INT));
#else
    flt all = flt_set(0);
    __builtin_memcpy(&all, &v, sizeof v);
    all = flt_quantize_half(all);
    __builtin_memcpy(&v, &all, sizeof v);
    return v;
#endif
}
#endif

#endif
