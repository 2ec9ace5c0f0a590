/* Lanes from memory and back: in a row, gathered, records of several words, past the caches. */
#ifndef GP_LANES_MEMORY_H
#define GP_LANES_MEMORY_H

#include "pipeline/base/lanes/channels.h"
#include "pipeline/base/lanes/shuffle.h"

/* --- in a row --------------------------------------------------------------------------------- */

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
#ifdef GP_SSE2_LANES
    _mm_stream_si128((__m128i *)to, (__m128i)all);
#elif defined GP_AVX2_LANES
    _mm256_stream_si256((__m256i *)to, (__m256i)all);
#elif defined GP_AVX512_LANES
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

/* Adds four floats to four, whatever the width of lanes; halves: the sums are rounded (R27). */
GP_INLINE void fours_add(float *to, const float *from, bool halves)
{
    flt4 sum, more;
    __builtin_memcpy(&sum, to, sizeof sum);
    __builtin_memcpy(&more, from, sizeof more);
    sum += more;
    if (halves)
        sum = flt4_quantize_half(sum);
    __builtin_memcpy(to, &sum, sizeof sum);
}

#if GP_LANES >= 8
/* The same of eight to eight. */
GP_INLINE void eights_add(float *to, itg8 more, bool halves)
{
    flt8 sum;
    __builtin_memcpy(&sum, to, sizeof sum);
    sum += (flt8)more;
    if (halves)
        sum = flt8_quantize_half(sum);
    __builtin_memcpy(to, &sum, sizeof sum);
}
#endif

/* GP_LANES bytes in a row. */
GP_INLINE itg itg_load_bytes(const uint8_t *from)
{
#ifdef GP_AVX512_LANES
    return (itg)_mm512_cvtepu8_epi32(_mm_loadu_si128((const __m128i *)(const void *)from));
#elif defined GP_AVX2_LANES
    return (itg)_mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i *)(const void *)from));
#else
    itg all;
    for (int lane = 0; lane < GP_LANES; lane++)
        all[lane] = from[lane];
    return all;
#endif
}

/* --- records of several words, each at a place of its own ------------------------------------- */

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
#ifdef GP_AVX512_LANES
    itg row[8]; /* two whole records each: 0 and 4, 1 and 5, ... 8 and 12, 9 and 13, ... */
    GP_UNROLL
    for (int k = 0; k < 8; k++) {
        const int first = k < 4 ? k : k + 4;
        itg_half one, other;
        __builtin_memcpy(&one, record[first], sizeof one);
        __builtin_memcpy(&other, record[first + 4], sizeof other);
        row[k] = itg_join_halves(one, other);
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

/* Four words of each lane from records in a row, and the way back. Vector by vector: gcc copies an
 * array of them by halves through memory, and waits for it. */
GP_INLINE void lanes_load4_row(const float *records, itg word[4])
{
    enum { FOURS = GP_LANES / 4 };
    itg row[4], from;
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        row[i] = (itg)flt_load(records + i * GP_LANES);
    lanes_transpose4(row, word); /* lane k of four q is record k FOURS + q */
    for (int lane = 0; lane < GP_LANES; lane++)
        from[lane] = lane % FOURS * 4 + lane / FOURS;
    GP_UNROLL
    for (int i = 0; i < 4 && FOURS > 1; i++)
        word[i] = itg_permute(word[i], from);
}

GP_INLINE void lanes_store4_row(float *records, const itg word[4])
{
    enum { FOURS = GP_LANES / 4 };
    itg row[4], mixed[4], from;
    for (int lane = 0; lane < GP_LANES; lane++)
        from[lane] = lane % 4 * FOURS + lane / 4;
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        mixed[i] = FOURS > 1 ? itg_permute(word[i], from) : word[i];
    lanes_transpose4(mixed, row);
    GP_UNROLL
    for (int i = 0; i < 4; i++)
        flt_store(records + i * GP_LANES, (flt)row[i]);
}

/* --- gathered by offsets ---------------------------------------------------------------------- */

/* Without optimization these intrinsics are macros that the compiler's own warnings stumble
 * over. */
#if defined GP_AVX512_LANES && defined __OPTIMIZE__
#define GP_GATHERS 1
enum { GATHERS_BY_LANE = false };
#else
enum { GATHERS_BY_LANE = true }; /* a second one from the same offsets has its addresses at hand */
#endif

/* One 32-bit word for each lane, from `offset` bytes after base, at any alignment. Processors with
 * sixteen lanes gather as fast as they load; the others spend more time on it than on loads. */
GP_INLINE itg itg_gather(const uint8_t *base, itg offset)
{
#ifdef GP_GATHERS
    return (itg)_mm512_i32gather_epi32((__m512i)offset, base, 1);
#else
    itg word = itg_set(0);
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        int32_t one;
        __builtin_memcpy(&one, base + offset[lane], sizeof one);
        word[lane] = one;
    }
    return word;
#endif
}

/* Two neighbouring 32-bit words for each lane; offsets are not negative. */
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
    itg4 first[GP_LANES / 4], second[GP_LANES / 4];
    uint32_t place[GP_LANES];
    __builtin_memcpy(place, &offset, sizeof place);
    GP_UNROLL
    for (int i = 0; i < GP_LANES; i += 4) {
        const uint8_t *at[4] = { base + place[i], base + place[i + 1], base + place[i + 2],
                                 base + place[i + 3] };
        __m128 left = (__m128)_mm_loadl_epi64((const __m128i *)(const void *)at[0]);
        __m128 right = (__m128)_mm_loadl_epi64((const __m128i *)(const void *)at[2]);
        left = _mm_loadh_pi(left, (const __m64 *)(const void *)at[1]);
        right = _mm_loadh_pi(right, (const __m64 *)(const void *)at[3]);
        first[i / 4] = (itg4)_mm_shuffle_ps(left, right, _MM_SHUFFLE(2, 0, 2, 0));
        second[i / 4] = (itg4)_mm_shuffle_ps(left, right, _MM_SHUFFLE(3, 1, 3, 1));
    }
    word[0] = itg_join_fours(first);
    word[1] = itg_join_fours(second);
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
