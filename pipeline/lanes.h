/* Lane vectors: GP_LANES floats or integers that go through the same operation side by side.
 *
 * The same source is compiled for several widths and instruction sets; every operation here gives
 * the same bits in each lane whatever the width, compiler or machine: IEEE add, sub, mul, div and
 * sqrt, selections by masks, and integer arithmetic that wraps. Masks are integer vectors, all ones
 * for true. This is the only file that may hold intrinsics.
 */
#ifndef GP_LANES_H
#define GP_LANES_H

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

/* The same value in every lane. (Subtracting from zero would lose the sign of -0.) */
GP_INLINE flt flt_set(float value)
{
    flt all;
    for (int lane = 0; lane < GP_LANES; lane++)
        all[lane] = value;
    return all;
}

GP_INLINE itg itg_set(int32_t value)
{
    itg all;
    for (int lane = 0; lane < GP_LANES; lane++)
        all[lane] = value;
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

GP_INLINE itg itg_lesser(itg a, itg b)
{
    return itg_select(a < b, a, b);
}

GP_INLINE itg itg_greater(itg a, itg b)
{
    return itg_select(a > b, a, b);
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
    flt root;
    for (int lane = 0; lane < GP_LANES; lane++)
        root[lane] = __builtin_sqrtf(a[lane]);
    return root;
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

/* --- records of four words ------------------------------------------------------------------------ */

/* Four words from each lane's own address, one vector a word: word[i] holds word i of every record.
 * Addresses need no alignment. */
GP_INLINE void lanes_load4(const void *const record[GP_LANES], itg word[4])
{
    typedef int32_t four __attribute__((vector_size(16)));
    four row[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        __builtin_memcpy(&row[lane], record[lane], sizeof row[lane]);
#if GP_LANES == 4
    itg r0 = row[0], r1 = row[1], r2 = row[2], r3 = row[3];
    itg low01 = __builtin_shufflevector(r0, r1, 0, 4, 1, 5);
    itg low23 = __builtin_shufflevector(r2, r3, 0, 4, 1, 5);
    itg high01 = __builtin_shufflevector(r0, r1, 2, 6, 3, 7);
    itg high23 = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
    word[0] = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
    word[1] = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
    word[2] = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
    word[3] = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
#elif GP_LANES == 8
#define GP_PAIR(a, b) __builtin_shufflevector(row[a], row[b], 0, 1, 2, 3, 4, 5, 6, 7)
    itg r0 = GP_PAIR(0, 4), r1 = GP_PAIR(1, 5), r2 = GP_PAIR(2, 6), r3 = GP_PAIR(3, 7);
    itg low01 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13);
    itg low23 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13);
    itg high01 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15);
    itg high23 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
    word[0] = __builtin_shufflevector(low01, low23, 0, 1, 8, 9, 4, 5, 12, 13);
    word[1] = __builtin_shufflevector(low01, low23, 2, 3, 10, 11, 6, 7, 14, 15);
    word[2] = __builtin_shufflevector(high01, high23, 0, 1, 8, 9, 4, 5, 12, 13);
    word[3] = __builtin_shufflevector(high01, high23, 2, 3, 10, 11, 6, 7, 14, 15);
#undef GP_PAIR
#else
    for (int i = 0; i < 4; i++)
        for (int lane = 0; lane < GP_LANES; lane++)
            word[i][lane] = row[lane][i];
#endif
}

/* --- 2x2 quads: lanes 4q..4q+3 are top left, top right, bottom left, bottom right --------------- */

#if GP_LANES == 4
#define GP_QUAD_SHUFFLE(a, i0, i1, i2, i3) __builtin_shufflevector(a, a, i0, i1, i2, i3)
#elif GP_LANES == 8
#define GP_QUAD_SHUFFLE(a, i0, i1, i2, i3)                                                         \
    __builtin_shufflevector(a, a, i0, i1, i2, i3, 4 + i0, 4 + i1, 4 + i2, 4 + i3)
#elif GP_LANES == 16
#define GP_QUAD_SHUFFLE(a, i0, i1, i2, i3)                                                         \
    __builtin_shufflevector(a, a, i0, i1, i2, i3, 4 + i0, 4 + i1, 4 + i2, 4 + i3, 8 + i0, 8 + i1,  \
                            8 + i2, 8 + i3, 12 + i0, 12 + i1, 12 + i2, 12 + i3)
#else
#error "GP_LANES must be 4, 8 or 16"
#endif

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

/* One 32-bit word for each lane, from `offset` bytes after base, at any alignment. */
GP_INLINE itg itg_gather(const uint8_t *base, itg offset)
{
    itg word;
    for (int lane = 0; lane < GP_LANES; lane++) {
        int32_t one;
        __builtin_memcpy(&one, base + offset[lane], sizeof one);
        word[lane] = one;
    }
    return word;
}

/* Two, or four, neighbouring 32-bit words for each lane. Loads of 64 and 128 bits and shuffles:
 * processors spend more time on their own gather instructions. */
#ifdef GP_X86_LANES

#if GP_LANES == 4
#define GP_JOIN_PARTS(part) ((itg)(part)[0])
#elif GP_LANES == 8
#define GP_JOIN_PARTS(part)                                                                        \
    ((itg)__builtin_shufflevector((part)[0], (part)[1], 0, 1, 2, 3, 4, 5, 6, 7))
#else
#define GP_JOIN_PARTS(part)                                                                        \
    ((itg)__builtin_shufflevector(                                                                 \
        __builtin_shufflevector((part)[0], (part)[1], 0, 1, 2, 3, 4, 5, 6, 7),                     \
        __builtin_shufflevector((part)[2], (part)[3], 0, 1, 2, 3, 4, 5, 6, 7), 0, 1, 2, 3, 4, 5,   \
        6, 7, 8, 9, 10, 11, 12, 13, 14, 15))
#endif

GP_INLINE void itg_gather2(const uint8_t *base, itg offset, itg word[2])
{
    int32_t at[GP_LANES];
    __m128 first[GP_LANES / 4], second[GP_LANES / 4];
    __builtin_memcpy(at, &offset, sizeof at);
    for (int i = 0; i < GP_LANES / 4; i++) {
        const int32_t *a = at + 4 * i;
        __m128 left = (__m128)_mm_loadl_epi64((const __m128i *)(const void *)(base + a[0]));
        __m128 right = (__m128)_mm_loadl_epi64((const __m128i *)(const void *)(base + a[2]));
        left = _mm_loadh_pi(left, (const __m64 *)(const void *)(base + a[1]));
        right = _mm_loadh_pi(right, (const __m64 *)(const void *)(base + a[3]));
        first[i] = _mm_shuffle_ps(left, right, _MM_SHUFFLE(2, 0, 2, 0));
        second[i] = _mm_shuffle_ps(left, right, _MM_SHUFFLE(3, 1, 3, 1));
    }
    word[0] = GP_JOIN_PARTS(first);
    word[1] = GP_JOIN_PARTS(second);
}

GP_INLINE void itg_gather4(const uint8_t *base, itg offset, itg word[4])
{
    int32_t at[GP_LANES];
    __m128 part[4][GP_LANES / 4];
    __builtin_memcpy(at, &offset, sizeof at);
    for (int i = 0; i < GP_LANES / 4; i++) {
        __m128 row[4];
        for (int k = 0; k < 4; k++)
            row[k] = _mm_loadu_ps((const float *)(const void *)(base + at[4 * i + k]));
        _MM_TRANSPOSE4_PS(row[0], row[1], row[2], row[3]);
        for (int k = 0; k < 4; k++)
            part[k][i] = row[k];
    }
    for (int k = 0; k < 4; k++)
        word[k] = GP_JOIN_PARTS(part[k]);
}

#else

GP_INLINE void itg_gather2(const uint8_t *base, itg offset, itg word[2])
{
    for (int k = 0; k < 2; k++)
        word[k] = itg_gather(base + 4 * k, offset);
}

GP_INLINE void itg_gather4(const uint8_t *base, itg offset, itg word[4])
{
    for (int k = 0; k < 4; k++)
        word[k] = itg_gather(base + 4 * k, offset);
}

#endif

#endif
