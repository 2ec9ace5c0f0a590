#include "apps/points/cloud/median.h"

#include <stdbool.h>

enum { MOST_SAMPLES = 31 };

/* A total order: which half an item is in does not depend on how the median is found. */
static inline bool before(const MedianItem *a, const MedianItem *b)
{
    return a->key < b->key || (a->key == b->key && a->surfel < b->surfel);
}

/* An item of about that rank, from a sample. */
static MedianItem item_near(const MedianItem *items, uint32_t count, uint32_t rank)
{
    MedianItem sample[MOST_SAMPLES];
    const uint32_t samples = count > 1024 ? MOST_SAMPLES : count > 64 ? 7 : 3;
    for (uint32_t i = 0; i < samples; i++) {
        const MedianItem item = items[(uint64_t)count * (2 * i + 1) / (2 * samples)];
        uint32_t at = i;
        for (; at > 0 && before(&item, &sample[at - 1]); at--)
            sample[at] = sample[at - 1];
        sample[at] = item;
    }
    const uint32_t which = (uint32_t)((uint64_t)rank * samples / count);
    return sample[which < samples ? which : samples - 1];
}

void median_part(MedianItem *items, uint32_t count, uint32_t first)
{
    uint32_t low = 0, high = count; /* before low and from high on all is in place */
    while (high - low > 1) {
        const MedianItem pivot = item_near(items + low, high - low, first - low);
        uint32_t i = low,
                 end = high; /* [low, i) are not behind the pivot, [end, high) not before */
        while (i < end) {
            while (before(&items[i], &pivot))
                i++;
            while (before(&pivot, &items[end - 1]))
                end--;
            if (i >= end)
                break;
            const MedianItem swap = items[i];
            items[i++] = items[--end];
            items[end] = swap;
        }
        if (first < end)
            high = end;
        else if (first > i)
            low = i;
        else
            return;
    }
}
