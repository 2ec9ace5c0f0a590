/* One tile on its way: where it is, what is drawn into it, and the stages' own memory, each of
 * which the header of its owner describes. */
#ifndef GP_FAST_TILE_H
#define GP_FAST_TILE_H

#include "pipeline/base/clock.h"
#include "pipeline/base/lanes.h"
#include "pipeline/fast/draws/draw.h"
#include "pipeline/fast/lanes/names.h"

typedef double dbl __attribute__((vector_size(8 * GP_LANES)));

/* Exact. */
GP_INLINE dbl dbl_from_itg(itg a)
{
#if GP_LANES == 16 && !defined(__OPTIMIZE__) /* gcc 12 gives up on this conversion at -O0 */
    dbl b;
    for (int lane = 0; lane < GP_LANES; lane++)
        b[lane] = a[lane];
    return b;
#else
    return __builtin_convertvector(a, dbl);
#endif
}

enum {
    FAST_PITCH = FAST_TILE + 16, /* a row of the tile, with room for a packet that runs over */
    FAST_PIXELS = FAST_PITCH * (FAST_TILE + 3),
};

/* A colour target inside the tile: packed formats as their words, all others by channel, as the
 * floats that reading the texels back would give. */
typedef union FastPlanes {
    uint32_t packed[FAST_PIXELS];
    float channel[4][FAST_PIXELS];
} FastPlanes;

typedef enum FastPhase { FAST_RASTER, FAST_SHADING, FAST_TRANSFER, FAST_PHASES } FastPhase;

typedef struct Tile {
    /* the clock, where it is asked for */
    bool timed;
    FastPhase phase; /* at work since `mark` */
    double mark, times[FAST_PHASES];
    uint64_t fragments_shaded;

    bool is_group_whole; /* no pass of the tile's group is drawn in parts */

    int32_t x0, y0, width, height; /* pixels; width and height of what the target has of it */

    /* the pass at work, and its targets, in their slots */
    const FastPass *pass;
    int targets;
    GpFormat depth_format;
    FastPlanes *planes[GP_MAX_TARGETS];
    uint32_t *depth; /* codes */
    uint8_t *stencil;

    /* the draw at work, and its number */
    const FastDraw *draw;
    uint32_t draw_number;
    bool is_drawn; /* whatever primitives of it are still to come */

    struct FastTileSlots *slots;                      /* memory/slots.h */
    struct FastRecords *records;                      /* shade/records.h */
    struct FastShaderBlock *block;                    /* shade/shader_block.h */
    struct FastLaneRuns *lane_runs;                   /* shade/interpolate_gathered.h */
    struct FastSums *sums;                            /* memory/sums.h */
    struct FastQueue *queue;                          /* shade/queue.h */
    struct FastVisibility *visibility;                /* shade/visibility.h */
    struct FastHierarchicalDepth *hierarchical_depth; /* raster/hierarchical_depth.h */
    struct FastSortedTriangles *sorted;               /* raster/sorted_triangles.h */
    struct FastFragments *fragments;                  /* shade/fragments.h */
    struct FastRepeated *repeated;                    /* shade/repeated.h */
} Tile;

GP_INLINE itg lane_numbers(void)
{
    itg numbers;
    for (int lane = 0; lane < GP_LANES; lane++)
        numbers[lane] = lane;
    return numbers;
}

/* a * b - c * d modulo 2^32: right wherever it fits, which is all that is asked; lanes whose
 * triangle is too large for it are found by its size and taken alone. */
GP_INLINE itg cross_lanes(itg a, itg b, itg c, itg d)
{
    return (itg)((utg)a * (utg)b - (utg)c * (utg)d);
}

/* Place of a pixel in a plane. */
GP_INLINE uint32_t fast_at(int32_t x, int32_t y)
{
    return (uint32_t)(y * FAST_PITCH + x);
}

/* The tile's part of what the draw may touch. */
GP_INLINE GpRect fast_tile_rect(const Tile *tile, const FastDraw *d)
{
    GpRect r = d->rect;
    r.x0 = r.x0 > tile->x0 ? r.x0 : tile->x0;
    r.y0 = r.y0 > tile->y0 ? r.y0 : tile->y0;
    r.x1 = r.x1 < tile->x0 + tile->width ? r.x1 : tile->x0 + tile->width;
    r.y1 = r.y1 < tile->y0 + tile->height ? r.y1 : tile->y0 + tile->height;
    return r;
}

/* Turns to another phase; returns the one before, to turn back to. */
GP_INLINE FastPhase fast_turn_to(Tile *tile, FastPhase phase)
{
    FastPhase before = tile->phase;
    if (tile->timed)
        tile->times[before] += fast_clock_lap(&tile->mark);
    tile->phase = phase;
    return before;
}

#endif
