/* Lane vectors: GP_LANES floats or integers that go through the same operation side by side.
 *
 * The same source is compiled for several widths and instruction sets; every operation here gives
 * the same bits in each lane whatever the width, compiler or machine: IEEE add, sub, mul, div and
 * sqrt, selections by masks, and integer arithmetic that wraps. Masks are integer vectors, all ones
 * for true. This is the only file that may hold intrinsics.
 */
#ifndef GP_LANES_H
#define GP_LANES_H

#include <stddef.h>
#include <stdbool.h>
#include <stdint.h>

/* Intrinsics stand only where compilers do worse than they could; each has its plain twin beside
 * it, which gives the same bits. GP_PLAIN_LANES compiles the twins everywhere. */
#if defined __SSE2__ && !defined GP_PLAIN_LANES
#define GP_X86_LANES 1
#include <immintrin.h>
#endif

#ifndef GP_LANES
#define GP_LANES 4
#endif

#define GP_INLINE static inline __attribute__((always_inline, unused))

/* Before a loop over lanes: written out, so that its vectors stay in registers. */
#if defined(__clang__)
#define GP_UNROLL _Pragma("clang loop unroll(full)")
#else
#define GP_UNROLL _Pragma("GCC unroll 16")
#endif

typedef float flt __attribute__((vector_size(4 * GP_LANES)));
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
    return (flt){ GP_TIMES_LANES(value) };
}

GP_INLINE itg itg_set(int32_t value)
{
    return (itg){ GP_TIMES_LANES(value) };
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

/* Per lane: a < b ? a : b, and a > b ? a : b. A NaN in a gives b; a NaN in b gives b too, so
 * shaders use the vocabulary's min and max, which follow rule R30. The instructions are defined
 * this way. */
GP_INLINE flt flt_lesser(flt a, flt b)
{
#if defined GP_X86_LANES && GP_LANES == 4
    return (flt)_mm_min_ps((__m128)a, (__m128)b);
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    return (flt)_mm256_min_ps((__m256)a, (__m256)b);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    return (flt)_mm512_min_ps((__m512)a, (__m512)b);
#else
    return flt_select(a < b, a, b);
#endif
}

GP_INLINE flt flt_greater(flt a, flt b)
{
#if defined GP_X86_LANES && GP_LANES == 4
    return (flt)_mm_max_ps((__m128)a, (__m128)b);
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    return (flt)_mm256_max_ps((__m256)a, (__m256)b);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    return (flt)_mm512_max_ps((__m512)a, (__m512)b);
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
GP_INLINE flt flt_lesser_number(flt a, flt b)
{
    if (flt_is_constant(b))
        return flt_lesser(a, b);
#if defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    __m256 x = (__m256)a, y = (__m256)b;
    return (flt)_mm256_blendv_ps(_mm256_min_ps(x, y), x, _mm256_cmp_ps(y, y, _CMP_UNORD_Q));
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    __m512 x = (__m512)a, y = (__m512)b;
    return (flt)_mm512_mask_min_ps(x, _mm512_cmp_ps_mask(y, y, _CMP_ORD_Q), x, y);
#else
    return flt_select(b != b, a, flt_lesser(a, b));
#endif
}

GP_INLINE flt flt_greater_number(flt a, flt b)
{
    if (flt_is_constant(b))
        return flt_greater(a, b);
#if defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    __m256 x = (__m256)a, y = (__m256)b;
    return (flt)_mm256_blendv_ps(_mm256_max_ps(x, y), x, _mm256_cmp_ps(y, y, _CMP_UNORD_Q));
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    __m512 x = (__m512)a, y = (__m512)b;
    return (flt)_mm512_mask_max_ps(x, _mm512_cmp_ps_mask(y, y, _CMP_ORD_Q), x, y);
#else
    return flt_select(b != b, a, flt_greater(a, b));
#endif
}

GP_INLINE itg itg_lesser(itg a, itg b)
{
#if defined GP_X86_LANES && GP_LANES == 8 && defined __AVX2__
    return (itg)_mm256_min_epi32((__m256i)a, (__m256i)b);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    return (itg)_mm512_min_epi32((__m512i)a, (__m512i)b);
#else
    return itg_select(a < b, a, b);
#endif
}

GP_INLINE itg itg_greater(itg a, itg b)
{
#if defined GP_X86_LANES && GP_LANES == 8 && defined __AVX2__
    return (itg)_mm256_max_epi32((__m256i)a, (__m256i)b);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    return (itg)_mm512_max_epi32((__m512i)a, (__m512i)b);
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
#if defined GP_X86_LANES && GP_LANES == 4 && defined __SSE4_1__
    return (flt)_mm_floor_ps((__m128)a);
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    return (flt)_mm256_floor_ps((__m256)a);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
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
#if defined GP_X86_LANES && GP_LANES == 4
    return (flt)_mm_sqrt_ps((__m128)a);
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    return (flt)_mm256_sqrt_ps((__m256)a);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    return (flt)_mm512_sqrt_ps((__m512)a);
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

/* code / 255 for whole numbers of 0 to 255, correctly rounded (R23), without the division: 1/255 is
 * (1 + 1/255) / 256, and the second product, which is small, may be a little wrong. */
GP_INLINE flt flt_from_unorm8(itg code)
{
    flt number = flt_from_itg(code);
    return number * 0x1p-8f + number * 0x1.010102p-16f;
}

/* Bit i of the result: lane i of the mask. */
GP_INLINE unsigned msk_bits(msk mask)
{
#if defined GP_X86_LANES && GP_LANES == 4
    return (unsigned)_mm_movemask_ps((__m128)mask);
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    return (unsigned)_mm256_movemask_ps((__m256)mask);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512DQ__
    return _mm512_movepi32_mask((__m512i)mask);
#else
    unsigned bits = 0;
    for (int lane = 0; lane < GP_LANES; lane++)
        bits |= (unsigned)(mask[lane] & 1) << lane;
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

/* --- fours of lanes -------------------------------------------------------------------------------- */

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

GP_INLINE itg itg_join_fours(const itg4 part[GP_LANES / 4])
{
#if GP_LANES == 4
    return part[0];
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX2__ /* gcc would shuffle registers */
    __m256i low = _mm256_castsi128_si256((__m128i)part[0]);
    return (itg)_mm256_inserti128_si256(low, (__m128i)part[1], 1);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    __m256i low = _mm256_castsi128_si256((__m128i)part[0]);
    __m256i high = _mm256_castsi128_si256((__m128i)part[2]);
    low = _mm256_inserti128_si256(low, (__m128i)part[1], 1);
    high = _mm256_inserti128_si256(high, (__m128i)part[3], 1);
    return (itg)_mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
#elif GP_LANES == 8
    return __builtin_shufflevector(part[0], part[1], 0, 1, 2, 3, 4, 5, 6, 7);
#else
    typedef int32_t itg8 __attribute__((vector_size(32)));
    itg8 low = __builtin_shufflevector(part[0], part[1], 0, 1, 2, 3, 4, 5, 6, 7);
    itg8 high = __builtin_shufflevector(part[2], part[3], 0, 1, 2, 3, 4, 5, 6, 7);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
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

/* --- records of four words ------------------------------------------------------------------------ */

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

/* Four words from each lane's own address, one vector a word: word[i] holds word i of every record.
 * Addresses need no alignment. */
GP_INLINE void lanes_load4(const void *const record[GP_LANES], itg word[4])
{
    itg row[4]; /* row[k]: records k, k + 4, ... */
    GP_UNROLL
    for (int k = 0; k < 4; k++) {
        itg4 part[GP_LANES / 4];
        GP_UNROLL
        for (int q = 0; q < GP_LANES / 4; q++)
            __builtin_memcpy(&part[q], record[4 * q + k], sizeof part[q]);
        row[k] = itg_join_fours(part);
    }
    lanes_transpose4(row, word);
}

/* The same for eight words. */
GP_INLINE void lanes_load8(const void *const record[GP_LANES], itg word[8])
{
#if defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    itg row[8]; /* two whole records each: 0 and 4, 1 and 5, ... 8 and 12, 9 and 13, ... */
    GP_UNROLL
    for (int k = 0; k < 8; k++) {
        const int first = k < 4 ? k : k + 4;
        __m512i low = _mm512_castsi256_si512(_mm256_loadu_si256(record[first]));
        row[k] = (itg)_mm512_inserti64x4(low, _mm256_loadu_si256(record[first + 4]), 1);
    }
    itg block[8]; /* words 0..3 and 4..7 of four records, and then of the next four */
    lanes_transpose4(row, block);
    lanes_transpose4(row + 4, block + 4);
    GP_UNROLL
    for (int i = 0; i < 4; i++) {
        __m512i low = (__m512i)block[i], high = (__m512i)block[4 + i];
        word[i] = (itg)_mm512_shuffle_i32x4(low, high, _MM_SHUFFLE(2, 0, 2, 0));
        word[4 + i] = (itg)_mm512_shuffle_i32x4(low, high, _MM_SHUFFLE(3, 1, 3, 1));
    }
#else
    const void *upper[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        upper[lane] = (const uint8_t *)record[lane] + 16;
    lanes_load4(record, word);
    lanes_load4(upper, word + 4);
#endif
}

/* The way back: the record of each lane, `stride` bytes after that of the lane before. */
GP_INLINE void lanes_store4(void *record, size_t stride, const itg word[4])
{
    itg row[4];
    lanes_transpose4(word, row);
    GP_UNROLL
    for (size_t k = 0; k < 4; k++) {
        itg4 part[GP_LANES / 4];
        itg_split_fours(row[k], part);
        GP_UNROLL
        for (size_t q = 0; q < GP_LANES / 4; q++)
            __builtin_memcpy((uint8_t *)record + (4 * q + k) * stride, &part[q], sizeof part[q]);
    }
}

/* The product of the low halves plus that of the high halves, all signed. */
GP_INLINE itg itg_dot2(itg a, itg b)
{
#if defined GP_X86_LANES && GP_LANES == 4
    return (itg)_mm_madd_epi16((__m128i)a, (__m128i)b);
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX2__
    return (itg)_mm256_madd_epi16((__m256i)a, (__m256i)b);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512BW__
    return (itg)_mm512_madd_epi16((__m512i)a, (__m512i)b);
#else
    utg low = (utg)((itg)((utg)a << 16) >> 16) * (utg)((itg)((utg)b << 16) >> 16);
    return (itg)(low + (utg)(a >> 16) * (utg)(b >> 16));
#endif
}

/* --- lanes from other lanes ---------------------------------------------------------------------- */

/* Lane i of the result: lane from[i], 0..GP_LANES-1, of a. */
GP_INLINE itg itg_pick(itg a, itg from)
{
#if defined GP_X86_LANES && GP_LANES == 8 && defined __AVX2__
    return (itg)_mm256_permutevar8x32_epi32((__m256i)a, (__m256i)from);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    return (itg)_mm512_permutexvar_epi32((__m512i)from, (__m512i)a);
#else
    itg picked;
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
GP_INLINE itg itg_running_sum(itg a)
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
#if defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32((__mmask16)bits, (__m512i)a));
#else
    for (; bits; bits &= bits - 1)
        *to++ = (uint32_t)a[__builtin_ctz(bits)];
#endif
}

/* --- interleaving --------------------------------------------------------------------------------- */

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

/* --- 2x2 quads: lanes 4q..4q+3 are top left, top right, bottom left, bottom right --------------- */

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

/* --- texel channels ----------------------------------------------------------------------------- */

#if defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512BW__
#define GP_AVX512_LANES 1
#endif

/* The code of an 8-bit channel (R24), floor(255 v + 0.5), for v from 0 to 1: in units of about 2^-25,
 * where 255 v is 256 m - m. The factor is a shade below 2^25, with which the floats on both sides of
 * each of the 255 bounds go the right way (tests/kernel/check_channels.c); the rest follows, since
 * every step keeps the order. */
GP_INLINE itg itg_unorm8(flt v)
{
    itg m = itg_from_flt(v * 0x1.fffffep24f);
    return (m + (1 << 16) - (m >> 8)) >> 17;
}

/* Words whose byte i, from the lowest, is the code of v[i]: up to 2, those above 1 as 1; negative
 * ones and NaN as 0. Or the average of 0 and floor(510 v), which averaging rounds up; rounded toward
 * zero no product reaches a whole number from below. */
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
#else
    itg word = itg_set(0);
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        word |= itg_unorm8(flt_lesser(flt_greater(v[i], flt_set(0)), flt_set(1))) << 8 * i;
    return word;
#endif
}

/* Byte i of each word as code / 255, correctly rounded (R23). Written to base 256 the quotient is
 * 0.ccc...; the first bit that 24 cannot hold is c's own leading one, so it is always rounded up. */
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

/* The value that a store and a load of an 8-bit channel leave (R23, R24), for v from 0 to 1. Rounded
 * toward zero no step crosses a multiple of 1/512 that it has not reached; behind 2^15 a float has room
 * for code / 256 and no more. The rest is flt_from_unorm8. */
GP_INLINE flt flt_through_unorm8(flt v)
{
#ifdef GP_AVX512_LANES
    enum { TO_ZERO = _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC };
    __m512 share = _mm512_mul_round_ps((__m512)v, _mm512_set1_ps(255.0f / 256.0f), TO_ZERO);
    __m512 up = _mm512_add_round_ps(share, _mm512_set1_ps(0x1p-9f), TO_ZERO);
    flt code = (flt)_mm512_add_round_ps(up, _mm512_set1_ps(0x1p15f), TO_ZERO) - 0x1p15f;
    return code + code * 0x1.010102p-8f;
#else
    return flt_from_unorm8(itg_unorm8(v));
#endif
}

/* The value that a store and a load of a half leave (R27); of a NaN its upper bits, quiet. */
GP_INLINE flt flt_through_half(flt v)
{
#ifdef GP_AVX512_LANES
    enum { NEAREST = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC };
    return (flt)_mm512_cvtph_ps(_mm512_maskz_cvtps_ph(0xffff, (__m512)v, NEAREST)); /* all lanes */
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

/* --- memory ------------------------------------------------------------------------------------- */

/* GP_LANES floats in a row, from and to any float's address. */
GP_INLINE flt flt_load(const float *from)
{
    flt all;
    __builtin_memcpy(&all, from, sizeof all);
    return all;
}

GP_INLINE void flt_store(float *to, flt all)
{
    __builtin_memcpy(to, &all, sizeof all);
}

/* Stores past the caches what no one reads soon; the address is a multiple of the vector's size.
 * Other threads may be told of it after the end. */
GP_INLINE void itg_stream(void *to, itg all)
{
#if defined GP_X86_LANES && GP_LANES == 4
    _mm_stream_si128((__m128i *)to, (__m128i)all);
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX__
    _mm256_stream_si256((__m256i *)to, (__m256i)all);
#elif defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    _mm512_stream_si512((__m512i *)to, (__m512i)all);
#else
    __builtin_memcpy(to, &all, sizeof all);
#endif
}

GP_INLINE void lanes_stream_end(void)
{
#ifdef GP_X86_LANES
    _mm_sfence();
#endif
}

/* Lanes that meet the end of a cache line less often than all of them. */
#ifdef GP_AVX512_LANES
#define GP_PIECE (GP_LANES / 2)
#else
#define GP_PIECE GP_LANES
#endif

/* Adds from[i] to to[i] for every bit i of `live`, of GP_PIECE in a row, and lets the others stay;
 * halves: the sums are rounded to halves (R27). */
GP_INLINE void piece_add(float *to, const float *from, unsigned live, bool halves)
{
#ifdef GP_AVX512_LANES
    enum { NEAREST = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC };
    const __mmask8 lanes = (__mmask8)live;
    const __m256 before = _mm256_loadu_ps(to);
    __m256 sum = _mm256_mask_add_ps(before, lanes, before, _mm256_loadu_ps(from));
    if (halves)
        sum = _mm256_mask_cvtph_ps(before, lanes, _mm256_maskz_cvtps_ph(0xff, sum, NEAREST));
    _mm256_storeu_ps(to, sum);
#else
    const flt before = flt_load(to);
    flt sum = before + flt_load(from);
    if (halves)
        sum = flt_through_half(sum);
    flt_store(to, flt_select(mask_of(live), sum, before));
#endif
}

/* GP_LANES bytes in a row. */
GP_INLINE itg itg_load_bytes(const uint8_t *from)
{
#if defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__
    return (itg)_mm512_cvtepu8_epi32(_mm_loadu_si128((const __m128i *)(const void *)from));
#elif defined GP_X86_LANES && GP_LANES == 8 && defined __AVX2__
    return (itg)_mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i *)(const void *)from));
#else
    itg all;
    for (int lane = 0; lane < GP_LANES; lane++)
        all[lane] = from[lane];
    return all;
#endif
}

/* Without optimization these intrinsics are macros that the compiler's own warnings stumble over. */
#if defined GP_X86_LANES && GP_LANES == 16 && defined __AVX512F__ && defined __OPTIMIZE__
#define GP_GATHERS 1
#endif

/* One 32-bit word for each lane, from `offset` bytes after base, at any alignment. Processors with
 * sixteen lanes gather as fast as they load; the others spend more time on it than on loads. */
GP_INLINE itg itg_gather(const uint8_t *base, itg offset)
{
#ifdef GP_GATHERS
    return (itg)_mm512_i32gather_epi32((__m512i)offset, base, 1);
#else
    itg word;
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        int32_t one;
        __builtin_memcpy(&one, base + offset[lane], sizeof one);
        word[lane] = one;
    }
    return word;
#endif
}

/* Two neighbouring 32-bit words for each lane. */
GP_INLINE void itg_gather2(const uint8_t *base, itg offset, itg word[2])
{
#ifdef GP_GATHERS
    __m256i low = _mm512_castsi512_si256((__m512i)offset);
    __m256i high = _mm512_extracti64x4_epi64((__m512i)offset, 1);
    itg a = (itg)_mm512_i32gather_epi64(low, base, 1);
    itg b = (itg)_mm512_i32gather_epi64(high, base, 1);
    word[0] =
        __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    word[1] =
        __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
#elif defined GP_X86_LANES
    __m128 first[GP_LANES / 4], second[GP_LANES / 4];
    GP_UNROLL
    for (int i = 0; i < GP_LANES; i += 4) {
        const uint8_t *at[4] = { base + offset[i], base + offset[i + 1], base + offset[i + 2],
                                 base + offset[i + 3] };
        __m128 left = (__m128)_mm_loadl_epi64((const __m128i *)(const void *)at[0]);
        __m128 right = (__m128)_mm_loadl_epi64((const __m128i *)(const void *)at[2]);
        left = _mm_loadh_pi(left, (const __m64 *)(const void *)at[1]);
        right = _mm_loadh_pi(right, (const __m64 *)(const void *)at[3]);
        first[i / 4] = _mm_shuffle_ps(left, right, _MM_SHUFFLE(2, 0, 2, 0));
        second[i / 4] = _mm_shuffle_ps(left, right, _MM_SHUFFLE(3, 1, 3, 1));
    }
    __builtin_memcpy(&word[0], first, sizeof word[0]);
    __builtin_memcpy(&word[1], second, sizeof word[1]);
#else
    for (int k = 0; k < 2; k++)
        word[k] = itg_gather(base + 4 * k, offset);
#endif
}

/* Four neighbouring 32-bit words for each lane. */
GP_INLINE void itg_gather4(const uint8_t *base, itg offset, itg word[4])
{
    const void *record[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        record[lane] = base + offset[lane];
    lanes_load4(record, word);
}

#endif
