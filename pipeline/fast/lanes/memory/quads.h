/* Words of the tile in lanes: of a row, of two rows as 2x2 quads side by side, or of some short
 * rows one after the other. */
#ifndef GP_FAST_QUADS_H
#define GP_FAST_QUADS_H

#include "pipeline/fast/lanes/memory/tile.h"

/* Quads of two rows of half as many pixels, and back. */
#if GP_LANES == 4
#define JOIN_ROWS(upper, lower) __builtin_shufflevector(upper, lower, 0, 1, 2, 3)
#define UPPER_ROW(quads)        __builtin_shufflevector(quads, quads, 0, 1)
#define LOWER_ROW(quads)        __builtin_shufflevector(quads, quads, 2, 3)
#define LOWER_LANES             0, 1
#define UPPER_LANES             2, 3
#elif GP_LANES == 8
#define JOIN_ROWS(upper, lower) __builtin_shufflevector(upper, lower, 0, 1, 4, 5, 2, 3, 6, 7)
#define UPPER_ROW(quads)        __builtin_shufflevector(quads, quads, 0, 1, 4, 5)
#define LOWER_ROW(quads)        __builtin_shufflevector(quads, quads, 2, 3, 6, 7)
#define LOWER_LANES             0, 1, 2, 3
#define UPPER_LANES             4, 5, 6, 7
#else
#define JOIN_ROWS(upper, lower)                                                                    \
    __builtin_shufflevector(upper, lower, 0, 1, 8, 9, 2, 3, 10, 11, 4, 5, 12, 13, 6, 7, 14, 15)
#define UPPER_ROW(quads) __builtin_shufflevector(quads, quads, 0, 1, 4, 5, 8, 9, 12, 13)
#define LOWER_ROW(quads) __builtin_shufflevector(quads, quads, 2, 3, 6, 7, 10, 11, 14, 15)
#define LOWER_LANES      0, 1, 2, 3, 4, 5, 6, 7
#define UPPER_LANES      8, 9, 10, 11, 12, 13, 14, 15
#endif

/* Places of the lanes, from the first: columns and rows. */
GP_INLINE itg lane_columns(bool quads)
{
    itg lane = lane_numbers();
    return quads ? (lane >> 2 << 1) + (lane & 1) : lane;
}

GP_INLINE itg lane_rows(bool quads)
{
    return quads ? lane_numbers() >> 1 & 1 : itg_set(0);
}

GP_INLINE itg load_lanes(const uint32_t *from, bool quads)
{
    itg words;
    if (quads) {
        itg_half upper, lower;
        __builtin_memcpy(&upper, from, sizeof upper);
        __builtin_memcpy(&lower, from + FAST_PITCH, sizeof lower);
        return JOIN_ROWS(upper, lower);
    }
    __builtin_memcpy(&words, from, sizeof words);
    return words;
}

GP_INLINE void store_lanes(uint32_t *to, bool quads, itg words)
{
    if (quads) {
        itg_half upper = UPPER_ROW(words), lower = LOWER_ROW(words);
        __builtin_memcpy(to, &upper, sizeof upper);
        __builtin_memcpy(to + FAST_PITCH, &lower, sizeof lower);
        return;
    }
    __builtin_memcpy(to, &words, sizeof words);
}

/* Rows of `wide` pixels: four, half of the lanes, or all. */
GP_INLINE itg load_rows(const uint32_t *from, int32_t wide)
{
    if (wide == GP_LANES)
        return load_lanes(from, false);
    if (wide == 4) {
        itg4 row[GP_LANES / 4];
        GP_UNROLL
        for (int r = 0; r < GP_LANES / 4; r++)
            __builtin_memcpy(&row[r], from + r * FAST_PITCH, sizeof row[r]);
        return itg_join_fours(row);
    }
    itg_half upper, lower;
    __builtin_memcpy(&upper, from, sizeof upper);
    __builtin_memcpy(&lower, from + FAST_PITCH, sizeof lower);
    return itg_join_halves(upper, lower);
}

GP_INLINE void store_rows(uint32_t *to, int32_t wide, itg words)
{
    if (wide == GP_LANES) {
        store_lanes(to, false, words);
        return;
    }
    if (wide == 4) {
        itg4 row[GP_LANES / 4];
        itg_split_fours(words, row);
        GP_UNROLL
        for (int r = 0; r < GP_LANES / 4; r++)
            __builtin_memcpy(to + r * FAST_PITCH, &row[r], sizeof row[r]);
        return;
    }
    itg_half upper = __builtin_shufflevector(words, words, LOWER_LANES);
    itg_half lower = __builtin_shufflevector(words, words, UPPER_LANES);
    __builtin_memcpy(to, &upper, sizeof upper);
    __builtin_memcpy(to + FAST_PITCH, &lower, sizeof lower);
}

#endif
