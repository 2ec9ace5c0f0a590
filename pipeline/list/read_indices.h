/* The range of an index array, in the lanes of whoever includes this. */
#ifndef GP_READ_INDICES_H
#define GP_READ_INDICES_H

#include "pipeline/base/lanes.h"
#include "pipeline/list/index_range.h"

#include <string.h>

static const GpIndexRange gp_no_indices = { UINT32_MAX, 0 };

static inline GpIndexRange gp_join_ranges(GpIndexRange a, GpIndexRange b)
{
    return (GpIndexRange){ a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high };
}

/* In lanes: compilers leave the plain loop as it is, and it takes longer than the memory. */
static inline GpIndexRange gp_read_indices(const uint32_t *indices, uint32_t count)
{
    const itg order = itg_set(INT32_MIN); /* of unsigned numbers, made that of signed ones */
    itg low = itg_set(INT32_MAX), high = itg_set(INT32_MIN);
    uint32_t i = 0;
    for (; i + GP_LANES <= count; i += GP_LANES) {
        itg number;
        memcpy(&number, indices + i, sizeof number);
        low = itg_lesser(low, number ^ order);
        high = itg_greater(high, number ^ order);
    }
    low ^= order;
    high ^= order;
    GpIndexRange range = gp_no_indices;
    for (int lane = 0; lane < GP_LANES; lane++)
        range = gp_join_ranges(range, (GpIndexRange){ (uint32_t)low[lane], (uint32_t)high[lane] });
    for (; i < count; i++)
        range = gp_join_ranges(range, (GpIndexRange){ indices[i], indices[i] });
    return range;
}

#endif
