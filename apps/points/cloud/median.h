/* Points parted by their place along an axis, as trees are built. */
#ifndef APPS_POINTS_CLOUD_MEDIAN_H
#define APPS_POINTS_CLOUD_MEDIAN_H

#include <stdint.h>

typedef struct MedianItem {
    float key; /* along the axis */
    float position[3];
    uint32_t surfel; /* its number; of two with the same key, the lower comes first */
} MedianItem;

/* Puts the `first` items that come first in front, 0 < first < count (Hoare's find). */
void median_part(MedianItem *items, uint32_t count, uint32_t first);

#endif
