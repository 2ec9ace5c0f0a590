/* Lanes from other lanes: 2x2 quads, fours, permutations, sums along the lanes. */
#ifndef GP_LANES_SHUFFLE_H
#define GP_LANES_SHUFFLE_H

#include "pipeline/base/lanes/types.h"

/* --- fours of lanes --------------------------------------------------------------------------- */

/* The same shuffle in every four lanes: indices 0..3 take from a, 4..7 from b. */
#define GP_FOUR_OF(i, q) (4 * (q) + (i) + ((i) < 4 ? 0 : GP_LANES - 4))
#define GP_FOUR(q, i0, i1, i2, i3)                                                                 \
    GP_FOUR_OF(i0, q), GP_FOUR_OF(i1, q), GP_FOUR_OF(i2, q), GP_FOUR_OF(i3, q)
#if GP_LANES == 4
#define GP_SHUFFLE_FOURS(a, b, ...) __builtin_shufflevector(a, b, GP_FOUR(0, __VA_ARGS__))
#elif GP_LANES == 8
#define GP_SHUFFLE_FOURS(a, b, ...)                                                                \
    __builtin_shufflevector(a, b, GP_FOUR(0, __VA_ARGS__), GP_FOUR(1, __VA_ARGS__))
#elif GP_LANES == 16
#define GP_SHUFFLE_FOURS(a, b, ...)                                                                \
    __builtin_shufflevector(a, b, GP_FOUR(0, __VA_ARGS__), GP_FOUR(1, __VA_ARGS__),                \
                            GP_FOUR(2, __VA_ARGS__), GP_FOUR(3, __VA_ARGS__))
#else
#error "GP_LANES must be 4, 8 or 16"
#endif

typedef int32_t itg4 __attribute__((vector_size(16)));
typedef int32_t itg_half __attribute__((vector_size(2 * GP_LANES)));

/* The lower lanes, then the upper ones. (By a shuffle, gcc would copy both halves first.) */
GP_INLINE itg itg_join_halves(itg_half low, itg_half high)
{
#ifdef GP_AVX2_LANES
    const __m256i lower = _mm256_castsi128_si256((__m128i)low);
    return (itg)_mm256_inserti128_si256(lower, (__m128i)high, 1);
#elif defined GP_AVX512_LANES
    const __m512i lower = _mm512_castsi256_si512((__m256i)low);
    return (itg)_mm512_inserti64x4(lower, (__m256i)high, 1);
#elif GP_LANES == 4
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#elif GP_LANES == 8
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#endif
}

GP_INLINE itg itg_join_fours(const itg4 part[GP_LANES / 4])
{
#if GP_LANES == 4
    return part[0];
#elif GP_LANES == 8
    return itg_join_halves(part[0], part[1]);
#elif defined GP_AVX512_LANES
    const __m256i low = _mm256_castsi128_si256((__m128i)part[0]);
    const __m256i high = _mm256_castsi128_si256((__m128i)part[2]);
    return itg_join_halves((itg_half)_mm256_inserti128_si256(low, (__m128i)part[1], 1),
                           (itg_half)_mm256_inserti128_si256(high, (__m128i)part[3], 1));
#else
    return itg_join_halves(__builtin_shufflevector(part[0], part[1], 0, 1, 2, 3, 4, 5, 6, 7),
                           __builtin_shufflevector(part[2], part[3], 0, 1, 2, 3, 4, 5, 6, 7));
#endif
}

GP_INLINE void itg_split_fours(itg all, itg4 part[GP_LANES / 4])
{
    part[0] = __builtin_shufflevector(all, all, 0, 1, 2, 3);
#if GP_LANES >= 8
    part[1] = __builtin_shufflevector(all, all, 4, 5, 6, 7);
#endif
#if GP_LANES == 16
    part[2] = __builtin_shufflevector(all, all, 8, 9, 10, 11);
    part[3] = __builtin_shufflevector(all, all, 12, 13, 14, 15);
#endif
}

#if GP_LANES >= 8
typedef int32_t itg8 __attribute__((vector_size(32)));

GP_INLINE void itg_split_eights(itg all, itg8 part[GP_LANES / 8])
{
    part[0] = __builtin_shufflevector(all, all, 0, 1, 2, 3, 4, 5, 6, 7);
#if GP_LANES == 16
    part[1] = __builtin_shufflevector(all, all, 8, 9, 10, 11, 12, 13, 14, 15);
#endif
}
#endif

/* Transposes every 4x4 block: lane k of four q in to[i] is lane i of four q in from[k]. */
GP_INLINE void lanes_transpose4(const itg from[4], itg to[4])
{
    itg low01 = GP_SHUFFLE_FOURS(from[0], from[1], 0, 4, 1, 5);
    itg low23 = GP_SHUFFLE_FOURS(from[2], from[3], 0, 4, 1, 5);
    itg high01 = GP_SHUFFLE_FOURS(from[0], from[1], 2, 6, 3, 7);
    itg high23 = GP_SHUFFLE_FOURS(from[2], from[3], 2, 6, 3, 7);
    to[0] = GP_SHUFFLE_FOURS(low01, low23, 0, 1, 4, 5);
    to[1] = GP_SHUFFLE_FOURS(low01, low23, 2, 3, 6, 7);
    to[2] = GP_SHUFFLE_FOURS(high01, high23, 0, 1, 4, 5);
    to[3] = GP_SHUFFLE_FOURS(high01, high23, 2, 3, 6, 7);
}

/* --- 2x2 quads: lanes 4q..4q+3 are top left, top right, bottom left, bottom right ------------- */

#define GP_QUAD_SHUFFLE(a, ...) GP_SHUFFLE_FOURS(a, a, __VA_ARGS__)

/* Right minus left, the same for both pixels of a row of the quad. */
GP_INLINE flt flt_quad_dx(flt a)
{
    return GP_QUAD_SHUFFLE(a, 1, 1, 3, 3) - GP_QUAD_SHUFFLE(a, 0, 0, 2, 2);
}

/* Lower minus upper, the same for both pixels of a column of the quad. */
GP_INLINE flt flt_quad_dy(flt a)
{
    return GP_QUAD_SHUFFLE(a, 2, 3, 2, 3) - GP_QUAD_SHUFFLE(a, 0, 1, 0, 1);
}

/* --- any lane to any other -------------------------------------------------------------------- */

/* Lane i of the result: lane from[i], 0..GP_LANES-1, of a. */
GP_INLINE itg itg_permute(itg a, itg from)
{
#ifdef GP_AVX2_LANES
    return (itg)_mm256_permutevar8x32_epi32((__m256i)a, (__m256i)from);
#elif defined GP_AVX512_LANES
    return (itg)_mm512_permutexvar_epi32((__m512i)from, (__m512i)a);
#else
    itg picked = itg_set(0);
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        picked[lane] = a[from[lane]];
    return picked;
#endif
}

/* Lane i of the result: lane i - 1 of a; lane 0: first. */
GP_INLINE itg itg_shift_in(itg a, int32_t first)
{
    const itg before = itg_set(first);
#if GP_LANES == 4
    return __builtin_shufflevector(before, a, 0, 4, 5, 6);
#elif GP_LANES == 8
    return __builtin_shufflevector(before, a, 0, 8, 9, 10, 11, 12, 13, 14);
#else
    return __builtin_shufflevector(before, a, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
                                   29, 30);
#endif
}

/* Lane i of the result: the sum of lanes 0..i. */
GP_INLINE itg itg_prefix_sum(itg a)
{
    const itg none = itg_set(0);
#if GP_LANES == 4
    a += __builtin_shufflevector(none, a, 0, 4, 5, 6);
    a += __builtin_shufflevector(none, a, 0, 1, 4, 5);
#elif GP_LANES == 8
    a += __builtin_shufflevector(none, a, 0, 8, 9, 10, 11, 12, 13, 14);
    a += __builtin_shufflevector(none, a, 0, 1, 8, 9, 10, 11, 12, 13);
    a += __builtin_shufflevector(none, a, 0, 1, 2, 3, 8, 9, 10, 11);
#else
    a += __builtin_shufflevector(none, a, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
                                 30);
    a += __builtin_shufflevector(none, a, 0, 1, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
                                 29);
    a += __builtin_shufflevector(none, a, 0, 1, 2, 3, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26,
                                 27);
    a += __builtin_shufflevector(none, a, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
#endif
    return a;
}

/* Writes the lanes whose bits are set one after the other; what lies behind them, up to GP_LANES
 * words in all, may be overwritten. */
GP_INLINE void itg_compress(uint32_t *to, unsigned bits, itg a)
{
#ifdef GP_AVX512_LANES
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32((__mmask16)bits, (__m512i)a));
#elif defined GP_AVX2_LANES
    static const uint32_t kept[16] = { 0x0,   0x0,     0x1,     0x100,    0x2,   0x200,
                                       0x201, 0x20100, 0x3,     0x300,    0x301, 0x30100,
                                       0x302, 0x30200, 0x30201, 0x3020100 }; /* a byte a lane */
    const __m128i low = _mm256_castsi256_si128((__m256i)a);
    const __m128i high = _mm256_extracti128_si256((__m256i)a, 1);
    const __m128i from_low = _mm_cvtepu8_epi32(_mm_cvtsi32_si128((int)kept[bits & 15]));
    const __m128i from_high = _mm_cvtepu8_epi32(_mm_cvtsi32_si128((int)kept[bits >> 4 & 15]));
    _mm_storeu_ps((float *)to, _mm_permutevar_ps((__m128)low, from_low));
    to += __builtin_popcount(bits & 15);
    _mm_storeu_ps((float *)to, _mm_permutevar_ps((__m128)high, from_high));
#else
    for (; bits; bits &= bits - 1)
        *to++ = (uint32_t)a[__builtin_ctz(bits)];
#endif
}

/* --- interleaving ----------------------------------------------------------------------------- */

/* Of the words of a and then b: the even ones, the odd ones; and the other way round, the words of
 * both in turn, as a lower and an upper half. */
#if GP_LANES == 4
#define GP_EVENS    0, 2, 4, 6
#define GP_ODDS     1, 3, 5, 7
#define GP_ZIP_LOW  0, 4, 1, 5
#define GP_ZIP_HIGH 2, 6, 3, 7
#elif GP_LANES == 8
#define GP_EVENS    0, 2, 4, 6, 8, 10, 12, 14
#define GP_ODDS     1, 3, 5, 7, 9, 11, 13, 15
#define GP_ZIP_LOW  0, 8, 1, 9, 2, 10, 3, 11
#define GP_ZIP_HIGH 4, 12, 5, 13, 6, 14, 7, 15
#else
#define GP_EVENS    0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30
#define GP_ODDS     1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31
#define GP_ZIP_LOW  0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23
#define GP_ZIP_HIGH 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31
#endif

GP_INLINE itg itg_evens(itg a, itg b)
{
    return __builtin_shufflevector(a, b, GP_EVENS);
}

GP_INLINE itg itg_odds(itg a, itg b)
{
    return __builtin_shufflevector(a, b, GP_ODDS);
}

GP_INLINE itg itg_zip_low(itg a, itg b)
{
    return __builtin_shufflevector(a, b, GP_ZIP_LOW);
}

GP_INLINE itg itg_zip_high(itg a, itg b)
{
    return __builtin_shufflevector(a, b, GP_ZIP_HIGH);
}

#endif
