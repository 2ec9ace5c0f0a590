#include "apps/points/cloud/distinct.h"

static bool is_same_place(const float *a, const float *b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static uint64_t hash_of(const float place[3])
{
    uint64_t hash = 0;
    for (int i = 0; i < 3; i++) {
        hash ^= gp_float_bits(place[i] + 0.0F); /* makes 0 of -0 */
        hash *= 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}

/* Points whose places in the table are asked for together, since most are not in a cache. */
enum { TOGETHER = 32 };

GpResult places_find(const float *positions, uint32_t count, uint32_t *first)
{
    size_t size = 16;
    while (size < 2 * (size_t)count)
        size *= 2;
    uint32_t *table = gp_alloc(size, sizeof *table); /* a point's number + 1; 0: free */
    if (!table)
        return GP_ERROR_MEMORY;
    size_t slot[TOGETHER];
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; i % TOGETHER == 0 && k < TOGETHER && k < count - i; k++) {
            slot[k] = hash_of(positions + 3 * (size_t)(i + k)) & (size - 1);
            __builtin_prefetch(&table[slot[k]]);
        }
        const float *place = positions + 3 * (size_t)i;
        size_t at = slot[i % TOGETHER];
        while (table[at] && !is_same_place(place, positions + 3 * (size_t)(table[at] - 1)))
            at = (at + 1) & (size - 1);
        if (!table[at])
            table[at] = i + 1;
        first[i] = table[at] - 1;
    }
    gp_free(table);
    return GP_OK;
}

GpResult distinct_places(const float *positions, uint32_t count, uint32_t *numbers,
                         uint32_t *distinct)
{
    if (places_find(positions, count, numbers) != GP_OK)
        return GP_ERROR_MEMORY;
    *distinct = 0;
    for (uint32_t i = 0; i < count; i++)
        if (numbers[i] == i)
            numbers[(*distinct)++] = i;
    return GP_OK;
}
