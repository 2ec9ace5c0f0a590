/* Ranges of index arrays: read in lanes, on many threads, and remembered. */
#include "pipeline/list/index_range.h"

#include "pipeline/base/lanes.h"

#include <string.h>

static const GpIndexRange nothing = { UINT32_MAX, 0 };

static GpIndexRange join(GpIndexRange a, GpIndexRange b)
{
    return (GpIndexRange){ a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high };
}

/* In lanes: compilers leave the plain loop as it is, and it takes longer than the memory. */
static GpIndexRange read_indices(const uint32_t *indices, uint32_t count)
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
    GpIndexRange range = nothing;
    for (int lane = 0; lane < GP_LANES; lane++)
        range = join(range, (GpIndexRange){ (uint32_t)low[lane], (uint32_t)high[lane] });
    for (; i < count; i++)
        range = join(range, (GpIndexRange){ indices[i], indices[i] });
    return range;
}

/* Plainly: whoever draws with them spells them out, which takes longer. */
static GpIndexRange read_indices16(const uint16_t *indices, uint32_t count)
{
    uint16_t low = UINT16_MAX, high = 0;
    for (uint32_t i = 0; i < count; i++) {
        low = indices[i] < low ? indices[i] : low;
        high = indices[i] > high ? indices[i] : high;
    }
    return (GpIndexRange){ low, high };
}

/* --- on many threads -------------------------------------------------------------------------- */

enum { MOST_PARTS = 64, LEAST_IN_PART = 1 << 15 };

typedef struct Job {
    const uint32_t *indices;
    uint32_t count, part; /* indices of all, and of a part but for the last */
    GpIndexRange found[MOST_PARTS];
} Job;

static void read_part(void *context, uint32_t item, int worker)
{
    (void)worker;
    Job *job = context;
    const uint32_t first = item * job->part, left = job->count - first;
    job->found[item] = read_indices(job->indices + first, left < job->part ? left : job->part);
}

static GpIndexRange read_in_parts(GpPool *pool, const uint32_t *indices, uint32_t count)
{
    Job job = { .indices = indices, .count = count, .part = count / MOST_PARTS + 1 };
    job.part = job.part < LEAST_IN_PART ? LEAST_IN_PART : job.part;
    const uint32_t parts = (count - 1) / job.part + 1;
    gp_pool_run(pool, parts, read_part, &job);
    GpIndexRange range = nothing;
    for (uint32_t i = 0; i < parts; i++)
        range = join(range, job.found[i]);
    return range;
}

/* --- what is known ---------------------------------------------------------------------------- */

GpIndexRange gp_index_range(GpIndexRanges *ranges, const GpGeometry *geometry)
{
    const uint32_t *indices = geometry->indices, count = geometry->index_count;
    if (!gp_geometry_is_indexed(geometry))
        return geometry->vertex_count ? (GpIndexRange){ 0, geometry->vertex_count - 1 } : nothing;
    if (count == 0)
        return nothing;
    if (!indices)
        return read_indices16(geometry->indices16, count);
    const size_t place =
        ((uintptr_t)indices >> 6 ^ (uintptr_t)indices >> 12 ^ count) % GP_COUNT(ranges->known);
    const bool is_known =
        ranges->known[place].indices == indices && ranges->known[place].count == count;
    if (!is_known) {
        ranges->known[place].indices = indices;
        ranges->known[place].count = count;
        ranges->known[place].range = ranges->pool && count > 2 * LEAST_IN_PART
                                         ? read_in_parts(ranges->pool, indices, count)
                                         : read_indices(indices, count);
    }
    return ranges->known[place].range;
}
