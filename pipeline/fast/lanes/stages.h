/* The stages that are compiled once for each lane width. */
#ifndef GP_FAST_STAGES_H
#define GP_FAST_STAGES_H

#include "pipeline/fast/draws/bin.h"
#include "pipeline/fast/draws/group.h"
#include "pipeline/list/counters.h"
#include "pipeline/list/index_range.h"

/* What one worker needs for the tile it is in; its content is the stages' own. */
typedef struct FastTileMemory FastTileMemory;

typedef struct FastStages {
    int lanes;
    /* The least and the greatest of indices: large meshes take 3 to 6 % less than by four lanes. */
    GpReadIndices read_indices;
    /* Shades vertices [first, first + count) of a draw (counted from its first vertex). */
    void (*shade_vertices)(const FastDraw *draw, uint32_t first, uint32_t count);
    /* Bins a range of a pass's primitives, or as many as there is memory for: culls, clips where it
     * must, and keeps their order. */
    void (*bin_range)(const FastPass *pass, FastRange *range);
    /* Draws one tile of a group, from clear or load to store. */
    void (*draw_tile)(const FastGroup *group, uint32_t tile, FastTileMemory *memory);
    size_t (*tile_bytes)(void);
    /* Memory for the fragments of passes that sort, or repeat others, before a group that has some:
     * at least the least. Borrowed. */
    size_t (*least_fragment_bytes)(void);
    void (*give_fragments)(FastTileMemory *tile, void *memory, size_t bytes);
    /* What a worker counts, and times where it is asked for: from zero, as its memory is at first,
     * and added up. */
    void (*start_counting)(FastTileMemory *memory);
    void (*add_counts)(const FastTileMemory *memory, GpCounters *counters, GpPhases *phases);
} FastStages;

/* Those that were compiled: a build may have fewer widths. */
extern const FastStages fast_stages4, fast_stages8, fast_stages16;

#endif
