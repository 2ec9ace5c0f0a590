/* Lanes: smaller and greater, rounding, roots, conversions, masks as bits. */
#ifndef GP_LANES_ARITHMETIC_H
#define GP_LANES_ARITHMETIC_H

#include "pipeline/base/lanes/types.h"

/* Per lane: a < b ? a : b, and a > b ? a : b. A NaN in a gives b; a NaN in b gives b too, so
 * shaders use the vocabulary's min and max, which follow rule R30. The instructions are defined
 * this way. */
GP_INLINE flt flt_lesser(flt a, flt b)
{
#ifdef GP_NATIVE
    return (flt)GP_NATIVE(min_ps)((gp_native_flt)a, (gp_native_flt)b);
#else
    return flt_select(a < b, a, b);
#endif
}

GP_INLINE flt flt_greater(flt a, flt b)
{
#ifdef GP_NATIVE
    return (flt)GP_NATIVE(max_ps)((gp_native_flt)a, (gp_native_flt)b);
#else
    return flt_select(a > b, a, b);
#endif
}

/* Whether the compiler knows that all lanes are one number, as flt_set makes them. */
GP_INLINE bool flt_is_constant(flt a)
{
    const itg bits = (itg)a;
    return __builtin_constant_p(bits[0]) && __builtin_constant_p(bits[GP_LANES - 1]) &&
           a[0] == a[0];
}

/* The same for numbers: where b is NaN, a; where a is, b (R30). */
GP_INLINE flt flt_min_num(flt a, flt b)
{
    if (flt_is_constant(b))
        return flt_lesser(a, b);
#ifdef GP_AVX2_LANES
    __m256 x = (__m256)a, y = (__m256)b;
    return (flt)_mm256_blendv_ps(_mm256_min_ps(x, y), x, _mm256_cmp_ps(y, y, _CMP_UNORD_Q));
#elif defined GP_AVX512_LANES
    __m512 x = (__m512)a, y = (__m512)b;
    return (flt)_mm512_mask_min_ps(x, _mm512_cmp_ps_mask(y, y, _CMP_ORD_Q), x, y);
#else
    return flt_select(b != b, a, flt_lesser(a, b));
#endif
}

GP_INLINE flt flt_max_num(flt a, flt b)
{
    if (flt_is_constant(b))
        return flt_greater(a, b);
#ifdef GP_AVX2_LANES
    __m256 x = (__m256)a, y = (__m256)b;
    return (flt)_mm256_blendv_ps(_mm256_max_ps(x, y), x, _mm256_cmp_ps(y, y, _CMP_UNORD_Q));
#elif defined GP_AVX512_LANES
    __m512 x = (__m512)a, y = (__m512)b;
    return (flt)_mm512_mask_max_ps(x, _mm512_cmp_ps_mask(y, y, _CMP_ORD_Q), x, y);
#else
    return flt_select(b != b, a, flt_greater(a, b));
#endif
}

GP_INLINE itg itg_lesser(itg a, itg b)
{
#if defined GP_AVX2_LANES || defined GP_AVX512_LANES
    return (itg)GP_NATIVE(min_epi32)((gp_native_itg)a, (gp_native_itg)b);
#else
    return itg_select(a < b, a, b);
#endif
}

GP_INLINE itg itg_greater(itg a, itg b)
{
#if defined GP_AVX2_LANES || defined GP_AVX512_LANES
    return (itg)GP_NATIVE(max_epi32)((gp_native_itg)a, (gp_native_itg)b);
#else
    return itg_select(a > b, a, b);
#endif
}

GP_INLINE flt flt_abs(flt a)
{
    return (flt)((itg)a & 0x7fffffff);
}

/* Largest integer not above a; +-0, infinities, NaN and every size of 2^23 and more are returned as
 * they are. The twin adds 2^23 to a smaller size, which leaves no place for a fraction. */
GP_INLINE flt flt_floor(flt a)
{
#if defined GP_SSE2_LANES && defined __SSE4_1__
    return (flt)_mm_floor_ps((__m128)a);
#elif defined GP_AVX2_LANES
    return (flt)_mm256_floor_ps((__m256)a);
#elif defined GP_AVX512_LANES
    return (flt)_mm512_floor_ps((__m512)a);
#else
    itg sign = (itg)a & INT32_MIN;
    flt size = (flt)((itg)a ^ sign);
    flt nearest = (flt)((itg)((size + 0x1p23f) - 0x1p23f) | sign);
    flt one_if_above = (flt)((nearest > a) & (itg)flt_set(1.0f));
    return flt_select(size < 0x1p23f, nearest - one_if_above, a);
#endif
}

/* Correctly rounded square root. */
GP_INLINE flt flt_sqrt(flt a)
{
#ifdef GP_NATIVE
    return (flt)GP_NATIVE(sqrt_ps)((gp_native_flt)a);
#else
    flt root;
    for (int lane = 0; lane < GP_LANES; lane++)
        root[lane] = __builtin_sqrtf(a[lane]);
    return root;
#endif
}

/* To integer, toward zero; every lane must be in range (callers clamp first). */
GP_INLINE itg itg_from_flt(flt a)
{
    return __builtin_convertvector(a, itg);
}

/* To float, to nearest even. */
GP_INLINE flt flt_from_itg(itg a)
{
    return __builtin_convertvector(a, flt);
}

/* The product of the low halves plus that of the high halves, all signed. */
GP_INLINE itg itg_dot2(itg a, itg b)
{
#ifdef GP_NATIVE
    return (itg)GP_NATIVE(madd_epi16)((gp_native_itg)a, (gp_native_itg)b);
#else
    utg low = (utg)((itg)((utg)a << 16) >> 16) * (utg)((itg)((utg)b << 16) >> 16);
    return (itg)(low + (utg)(a >> 16) * (utg)(b >> 16));
#endif
}

/* Bit i of the result: the sign of lane i, which of a mask is whether it is set. */
GP_INLINE unsigned msk_bits(msk mask)
{
#ifdef GP_SSE2_LANES
    return (unsigned)_mm_movemask_ps((__m128)mask);
#elif defined GP_AVX2_LANES
    return (unsigned)_mm256_movemask_ps((__m256)mask);
#elif defined GP_AVX512_LANES
    return _mm512_movepi32_mask((__m512i)mask);
#else
    unsigned bits = 0;
    for (int lane = 0; lane < GP_LANES; lane++)
        bits |= (unsigned)(mask[lane] < 0) << lane;
    return bits;
#endif
}

/* The mask whose bits msk_bits would give. */
GP_INLINE msk mask_of(unsigned bits)
{
    itg bit;
    for (int lane = 0; lane < GP_LANES; lane++)
        bit[lane] = 1 << lane;
    return (msk)((itg_set((int32_t)bits) & bit) != 0);
}

GP_INLINE bool msk_any(msk mask)
{
#ifdef GP_X86_LANES
    return msk_bits(mask) != 0;
#else
    typedef int64_t pairs __attribute__((vector_size(4 * GP_LANES)));
    pairs lanes = (pairs)mask;
    int64_t set = 0;
    for (int i = 0; i < GP_LANES / 2; i++)
        set |= lanes[i];
    return set != 0;
#endif
}

#endif
