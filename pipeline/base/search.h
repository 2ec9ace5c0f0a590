/* Binary search in arrays of structs that are sorted by one member. */
#ifndef GP_SEARCH_H
#define GP_SEARCH_H

#include <stddef.h>
#include <stdint.h>

/* Number of the last element whose member is at most `key`; 0 where that of none is.
 * in   member: the first element's; stride: bytes from one to the next; count: elements, at least
 *      1 */
static inline uint32_t gp_last_at_most(const uint32_t *member, size_t stride, uint32_t count,
                                       uint32_t key)
{
    uint32_t low = 0, high = count;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        const void *at = (const char *)member + middle * stride;
        *(*(const uint32_t *)at <= key ? &low : &high) = middle;
    }
    return low;
}

#endif
