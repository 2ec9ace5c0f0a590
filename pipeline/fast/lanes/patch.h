/* Where the lanes of a patch are. */
#ifndef GP_FAST_PATCH_H
#define GP_FAST_PATCH_H

#include "pipeline/fast/lanes/tile.h"

enum { QUADS_WIDE = GP_LANES / 2 }; /* pixels across a patch of quads */

GP_INLINE itg patch_x(const FastPatch *patch)
{
    itg lane = lane_numbers();
    return patch->x + (patch->quads ? (lane >> 2 << 1) + (lane & 1) : lane);
}

GP_INLINE itg patch_y(const FastPatch *patch)
{
    itg lane = lane_numbers();
    return patch->y + (patch->quads ? lane >> 1 & 1 : itg_set(0));
}

#if GP_LANES == 4
#define QUADS_FROM_ROWS(a)  (a)
#define ROWS_FROM_QUADS(a)  (a)
#elif GP_LANES == 8
#define QUADS_FROM_ROWS(a)  __builtin_shufflevector(a, a, 0, 1, 4, 5, 2, 3, 6, 7)
#define ROWS_FROM_QUADS(a)  __builtin_shufflevector(a, a, 0, 1, 4, 5, 2, 3, 6, 7)
#else
#define QUADS_FROM_ROWS(a)                                                                         \
    __builtin_shufflevector(a, a, 0, 1, 8, 9, 2, 3, 10, 11, 4, 5, 12, 13, 6, 7, 14, 15)
#define ROWS_FROM_QUADS(a)                                                                         \
    __builtin_shufflevector(a, a, 0, 1, 4, 5, 8, 9, 12, 13, 2, 3, 6, 7, 10, 11, 14, 15)
#endif

/* The words of a plane under a patch. */
GP_INLINE itg load_patch(const void *plane, const FastPatch *patch)
{
    const uint32_t *from = (const uint32_t *)plane + fast_at(patch->x, patch->y);
    itg words;
    if (!patch->quads) {
        __builtin_memcpy(&words, from, sizeof words);
        return words;
    }
    __builtin_memcpy(&words, from, sizeof words / 2);
    __builtin_memcpy((char *)&words + sizeof words / 2, from + FAST_PITCH, sizeof words / 2);
    return QUADS_FROM_ROWS(words);
}

GP_INLINE void store_patch(void *plane, const FastPatch *patch, unsigned live, itg words)
{
    uint32_t *to = (uint32_t *)plane + fast_at(patch->x, patch->y);
    words = itg_select(mask_of(live), words, load_patch(plane, patch));
    if (!patch->quads) {
        __builtin_memcpy(to, &words, sizeof words);
        return;
    }
    words = ROWS_FROM_QUADS(words);
    __builtin_memcpy(to, &words, sizeof words / 2);
    __builtin_memcpy(to + FAST_PITCH, (char *)&words + sizeof words / 2, sizeof words / 2);
}

#endif
