/* The lanes themselves: types, one value in all of them, and choosing between them. */
#ifndef GP_LANES_TYPES_H
#define GP_LANES_TYPES_H

#include <stddef.h>
#include <stdbool.h>
#include <stdint.h>

/* Intrinsics stand only where compilers do worse than they could; each has its plain twin beside
 * it, which gives the same bits. GP_PLAIN_LANES compiles the twins everywhere. (Of vectors that a
 * twin fills lane by lane some are set first, where gcc takes them for unset.) */
#if defined __SSE2__ && !defined GP_PLAIN_LANES
#define GP_X86_LANES 1
#ifdef __AVX__
#include <immintrin.h>
#else
#include <emmintrin.h> /* a fortieth of the other's text, which takes as long to read as a shader to compile */
#endif
#endif

#ifndef GP_LANES
#define GP_LANES 4
#endif

#define GP_INLINE static inline __attribute__((always_inline, unused))

/* Before a loop over lanes: written out, so that its vectors stay in registers. */
#if defined(__clang__)
#define GP_UNROLL _Pragma("clang loop unroll(full)")
#elif defined __OPTIMIZE__
#define GP_UNROLL _Pragma("GCC unroll 16")
#else
#define GP_UNROLL /* gcc warns that it ignores it */
#endif

/* GP_NATIVE(op): the intrinsic of one operation on whole vectors, where they are the processor's
 * own; gp_native_flt and gp_native_itg: what it takes and gives. */
#if defined GP_X86_LANES && GP_LANES == 4
#define GP_NATIVE(op) _mm_##op
#define GP_SSE2_LANES 1
typedef __m128 gp_native_flt;
typedef __m128i gp_native_itg;
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX2__
#define GP_NATIVE(op) _mm256_##op
#define GP_AVX2_LANES 1
typedef __m256 gp_native_flt;
typedef __m256i gp_native_itg;
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__ && defined __AVX512BW__ &&     \
    defined __AVX512DQ__
#define GP_NATIVE(op)   _mm512_##op
#define GP_AVX512_LANES 1
typedef __m512 gp_native_flt;
typedef __m512i gp_native_itg;
#endif

typedef float flt __attribute__((vector_size(4 * GP_LANES)));
typedef float flt4 __attribute__((vector_size(16)));
typedef float flt8 __attribute__((vector_size(32)));
typedef int32_t itg __attribute__((vector_size(4 * GP_LANES)));
typedef uint32_t utg __attribute__((vector_size(4 * GP_LANES)));
typedef itg msk; /* per lane: -1 true, 0 false; what comparisons of flt and itg give */

#define GP_TIMES4(value)  value, value, value, value
#define GP_TIMES8(value)  GP_TIMES4(value), GP_TIMES4(value)
#define GP_TIMES16(value) GP_TIMES8(value), GP_TIMES8(value)
#if GP_LANES == 4
#define GP_TIMES_LANES(value) GP_TIMES4(value)
#elif GP_LANES == 8
#define GP_TIMES_LANES(value) GP_TIMES8(value)
#elif GP_LANES == 16
#define GP_TIMES_LANES(value) GP_TIMES16(value)
#else
#error "GP_LANES must be 4, 8 or 16"
#endif

/* The same value in every lane. */
GP_INLINE flt flt_set(float value)
{
    const flt all = { GP_TIMES_LANES(value) };
    return all;
}

GP_INLINE itg itg_set(int32_t value)
{
    const itg all = { GP_TIMES_LANES(value) };
    return all;
}

/* Per lane: mask ? a : b. */
GP_INLINE flt flt_select(msk mask, flt a, flt b)
{
    return (flt)(((itg)a & mask) | ((itg)b & ~mask));
}

GP_INLINE itg itg_select(msk mask, itg a, itg b)
{
    return (a & mask) | (b & ~mask);
}

/* Per lane: sign < 0 ? a : b. */
GP_INLINE itg itg_select_negative(itg sign, itg a, itg b)
{
#ifdef GP_AVX2_LANES /* one instruction in place of four */
    return (itg)_mm256_blendv_ps((__m256)b, (__m256)a, (__m256)sign);
#else
    return itg_select((msk)(sign >> 31), a, b);
#endif
}

#endif
