/* Words of the tile in lanes: of a row, or of two rows as 2x2 quads side by side. */
#ifndef GP_FAST_QUADS_H
#define GP_FAST_QUADS_H

#include "pipeline/fast/lanes/tile.h"

typedef int32_t itg_half __attribute__((vector_size(2 * GP_LANES)));

/* Quads of two rows of half as many pixels, and back. */
#if GP_LANES == 4
#define JOIN_ROWS(upper, lower) __builtin_shufflevector(upper, lower, 0, 1, 2, 3)
#define UPPER_ROW(quads)        __builtin_shufflevector(quads, quads, 0, 1)
#define LOWER_ROW(quads)        __builtin_shufflevector(quads, quads, 2, 3)
#elif GP_LANES == 8
#define JOIN_ROWS(upper, lower) __builtin_shufflevector(upper, lower, 0, 1, 4, 5, 2, 3, 6, 7)
#define UPPER_ROW(quads)        __builtin_shufflevector(quads, quads, 0, 1, 4, 5)
#define LOWER_ROW(quads)        __builtin_shufflevector(quads, quads, 2, 3, 6, 7)
#else
#define JOIN_ROWS(upper, lower)                                                                    \
    __builtin_shufflevector(upper, lower, 0, 1, 8, 9, 2, 3, 10, 11, 4, 5, 12, 13, 6, 7, 14, 15)
#define UPPER_ROW(quads) __builtin_shufflevector(quads, quads, 0, 1, 4, 5, 8, 9, 12, 13)
#define LOWER_ROW(quads) __builtin_shufflevector(quads, quads, 2, 3, 6, 7, 10, 11, 14, 15)
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

#endif
