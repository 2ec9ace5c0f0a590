/* Ranges of the vertices that index arrays name: each array is read once a list, by as many threads
 * as there are, however many draws share it. */
#ifndef GP_INDEX_RANGE_H
#define GP_INDEX_RANGE_H

#include "pipeline/resources/geometry.h"
#include "pipeline/base/pool.h"

/* Vertices low..high; low > high: none. */
typedef struct GpIndexRange {
    uint32_t low, high;
} GpIndexRange;

/* Finds the range of an array. */
typedef GpIndexRange (*GpReadIndices)(const uint32_t *indices, uint32_t count);

/* The last few ranges of a list whose arrays do not change meanwhile. Starts as zeros, but for the
 * pool and its reader. */
typedef struct GpIndexRanges {
    GpPool *pool;       /* NULL: large arrays are read by the calling thread alone */
    GpReadIndices read; /* NULL: by the lanes that every processor has */
    struct {
        const uint32_t *indices;
        uint32_t count;
        GpIndexRange range;
    } known[32];
} GpIndexRanges;

/* The vertices that a geometry's primitives use; without indices, all that it has. */
GpIndexRange gp_index_range(GpIndexRanges *ranges, const GpGeometry *geometry);

#endif
