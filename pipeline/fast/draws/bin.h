/* Binning: which tiles each triangle or point touches, in submission order. */
#ifndef GP_FAST_BIN_H
#define GP_FAST_BIN_H

#include "pipeline/fast/draws/draw.h"

#include <stdatomic.h>

/* A triangle that the clipper cut: a fan of triangles, with corners of their own. */
typedef struct FastClipPolygon {
    uint32_t primitive; /* of the pass */
    uint32_t first, corners;
} FastClipPolygon;

/* Neighbours of one draw that touch a tile: primitive first + i for every bit i of lanes. */
typedef struct FastPrimitiveMask {
    uint32_t first;
    uint32_t lanes;
} FastPrimitiveMask;

/* On a group's first and only primitive: look it up in the clip polygons. */
#define FAST_CLIPPED_FLAG 0x80000000u

/* Some groups of one tile; chunks of a tile are linked in order. (Of half the size points take 4 %
 * more.) */
enum { FAST_CHUNK = 31 }; /* fills 256 bytes, with what comes before them */
typedef struct FastChunk {
    uint32_t count;
    uint32_t next; /* chunk number, 0: the last */
    FastPrimitiveMask group[FAST_CHUNK];
} FastChunk;

/* Memory that all bins share. Where it runs out, what is binned so far is drawn first. */
typedef struct FastBudget {
    atomic_size_t used;
    size_t limit;
} FastBudget;

static inline bool fast_budget_left(const FastBudget *budget)
{
    return atomic_load_explicit(&budget->used, memory_order_relaxed) < budget->limit;
}

/* Primitives of one range, by tiles, in submission order. Kept from frame to frame. */
typedef struct FastRange {
    uint32_t first, end, reached; /* primitives of the pass; those before `reached` are binned */
    FastBudget *budget;
    uint32_t *head, *tail; /* of each tile, chunk numbers, 0: none */
    uint32_t tile_room;
    FastChunk *chunks; /* number 0 is every tile's first, and always full */
    uint32_t chunk_count, chunk_room;

    FastClipPolygon *polygons; /* by rising primitive */
    uint32_t polygon_count, polygon_room;
    GpScreenVertex *corners; /* of the polygons */
    float *corner_varyings;  /* GP_MAX_VARYINGS floats a corner */
    uint32_t corner_count, corner_room, varying_room;
    uint64_t clipped;
    bool failed; /* no memory */
} FastRange;

/* Starts a range for a pass with so many tiles; false when memory is short. */
bool fast_range_begin(FastRange *range, uint32_t tiles);

/* Gives back a range's memory, and what it had of the budget; its primitives stay what they are. */
void fast_range_free(FastRange *range);

/* The group that was last added to a tile; one that is no primitive's where there is none. */
static inline FastPrimitiveMask *fast_last_group(const FastRange *range, uint32_t tile)
{
    FastChunk *chunk = &range->chunks[range->tail[tile]];
    return &chunk->group[chunk->count - 1];
}

/* A fresh chunk at the end of a tile's list; NULL, noted in the range, when memory is short. */
FastChunk *fast_add_chunk(FastRange *range, uint32_t tile);

static inline void fast_add_to_tile(FastRange *range, uint32_t tile, FastPrimitiveMask group)
{
    FastChunk *chunk = &range->chunks[range->tail[tile]];
    if (chunk->count == FAST_CHUNK)
        chunk = fast_add_chunk(range, tile);
    if (chunk)
        chunk->group[chunk->count++] = group;
}

/* The same of one or some of the primitives from group.first on, of which the tile may have
 * others. */
static inline void fast_add_to_group(FastRange *range, uint32_t tile, FastPrimitiveMask group)
{
    FastPrimitiveMask *last = fast_last_group(range, tile);
    if (last->first == group.first)
        last->lanes |= group.lanes;
    else
        fast_add_to_tile(range, tile, group);
}

/* Adds the primitives of `group` to the bin of every tile that the box touches; notes a failure in
 * the range. */
void fast_bin_box(const FastPass *pass, FastRange *range, FastPrimitiveMask group,
                  const FastBox *box);

/* Bins triangles of any size, and such as are to be clipped. */
void fast_bin_triangles(const FastPass *pass, const FastDraw *draw, FastRange *range,
                        FastPrimitiveMask group);

/* The clip polygon of a primitive that was binned with FAST_CLIPPED_FLAG. */
const FastClipPolygon *fast_find_polygon(const FastRange *range, uint32_t primitive);

#endif
