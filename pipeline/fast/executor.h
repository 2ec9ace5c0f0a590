/* The executor's own memory, and the two halves of a group's way: preparing it and running it. */
#ifndef GP_FAST_EXECUTOR_H
#define GP_FAST_EXECUTOR_H

#include "pipeline/fast/arena.h"
#include "pipeline/fast/fast.h"
#include "pipeline/fast/lanes/stages.h"
#include "pipeline/list/list_check.h"
#include "pipeline/base/pool.h"

struct GpFast {
    GpPool *pool;
    FastTileMemory **tiles; /* one a worker, made when first needed */
    int lanes;              /* that they were made for */
    bool timed;             /* the list that runs */
    GpCheckedPrograms programs;
    GpIndexRanges indices; /* of the list, from its check to the end of its run */
    /* that wait to be sorted, or to come again: one a worker, made when first needed */
    void **fragments;
    size_t fragment_bytes;
    size_t limit, vertex_bytes;
    FastArena arena;   /* draws and shaded vertices of the group */
    FastRange *ranges; /* kept for the memory they hold */
    uint32_t range_room;
    FastBudget budget; /* of the ranges */
    double mark;       /* when the last phase ended */
};

/* Where in a list the next group starts. */
typedef struct FastCursor {
    const GpList *list;
    const uint32_t *group_of; /* gp_list_groups */
    uint32_t pass, draw;
} FastCursor;

/* Prepares passes of one group of the list, as many as there are slots and memory for, and moves
 * the cursor behind them; false when memory is short. */
bool fast_prepare_group(GpFast *fast, FastCursor *at, int lanes, FastGroup *group);

/* Bytes that a list may take of the executor, beside the surfaces and the geometry that it names:
 * at the most, but for bins of passes that sort, whose size depends on how many tiles a triangle
 * meets.
 * in   list: checked; tile_bytes, fragment_bytes: of a worker */
uint64_t gp_fast_bytes(const GpFast *fast, const GpList *list, size_t tile_bytes,
                       size_t fragment_bytes);

/* Vertices, bins and tiles; false when memory is short. */
bool fast_run_group(GpFast *fast, FastGroup *group, const FastStages *stages, GpCounters *counters,
                    GpPhases *phases);

#endif
