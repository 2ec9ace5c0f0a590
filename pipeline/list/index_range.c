/* Ranges of index arrays: read in lanes, on many threads, and remembered. */
#include "pipeline/list/index_range.h"

#include "pipeline/list/read_indices.h"

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
    GpReadIndices read;
    const uint32_t *indices;
    uint32_t count, part; /* indices of all, and of a part but for the last */
    GpIndexRange found[MOST_PARTS];
} Job;

static void read_part(void *context, uint32_t item, int worker)
{
    (void)worker;
    Job *job = context;
    const uint32_t first = item * job->part, left = job->count - first;
    job->found[item] = job->read(job->indices + first, left < job->part ? left : job->part);
}

static GpIndexRange read_in_parts(GpPool *pool, GpReadIndices read, const uint32_t *indices,
                                  uint32_t count)
{
    Job job = { .read = read, .indices = indices, .count = count, .part = count / MOST_PARTS + 1 };
    job.part = job.part < LEAST_IN_PART ? LEAST_IN_PART : job.part;
    const uint32_t parts = (count - 1) / job.part + 1;
    gp_pool_run(pool, parts, read_part, &job);
    GpIndexRange range = gp_no_indices;
    for (uint32_t i = 0; i < parts; i++)
        range = gp_join_ranges(range, job.found[i]);
    return range;
}

/* --- what is known ---------------------------------------------------------------------------- */

GpIndexRange gp_index_range(GpIndexRanges *ranges, const GpGeometry *geometry)
{
    const uint32_t *indices = geometry->indices, count = geometry->index_count;
    if (!gp_geometry_is_indexed(geometry))
        return geometry->vertex_count ? (GpIndexRange){ 0, geometry->vertex_count - 1 }
                                      : gp_no_indices;
    if (count == 0)
        return gp_no_indices;
    if (!indices)
        return read_indices16(geometry->indices16, count);
    const size_t place =
        ((uintptr_t)indices >> 6 ^ (uintptr_t)indices >> 12 ^ count) % GP_COUNT(ranges->known);
    const bool is_known =
        ranges->known[place].indices == indices && ranges->known[place].count == count;
    if (!is_known) {
        const GpReadIndices read = ranges->read ? ranges->read : gp_read_indices;
        ranges->known[place].indices = indices;
        ranges->known[place].count = count;
        ranges->known[place].range = ranges->pool && count > 2 * LEAST_IN_PART
                                         ? read_in_parts(ranges->pool, read, indices, count)
                                         : read(indices, count);
    }
    return ranges->known[place].range;
}
