/* The executor: its memory, and lists run group by group. */
#include "pipeline/base/clock.h"
#include "pipeline/fast/executor.h"
#include "pipeline/list/list_check.h"

#include <stdlib.h>

/* Bytes of shaded vertices, and of bins, after which what is there is drawn before more is made. */
enum { LIMIT = 24 << 20 };

/* Bytes that fragments of one tile may take while they wait to be sorted, or to come again. No page
 * of it is touched before it is needed. */
enum { FRAGMENT_BYTES = 14 << 20 };

GpResult gp_fast_create(int threads, GpFast **fast, GpError *error)
{
    GpFast *f = gp_alloc(1, sizeof *f);
    if (!f)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the fast executor");
    GpResult result = gp_pool_create(threads, &f->pool, error);
    if (result == GP_OK) {
        f->tiles = gp_alloc((size_t)threads, sizeof(FastTileMemory *));
        f->fragments = gp_alloc((size_t)threads, sizeof(void *));
        if (!f->tiles || !f->fragments)
            result = gp_fail(error, GP_ERROR_MEMORY, "no memory for the fast executor");
    }
    if (result) {
        gp_pool_destroy(&f->pool);
        gp_free(f->tiles);
        gp_free(f->fragments);
        gp_free(f);
        return result;
    }
    gp_fast_set_limit(f, LIMIT);
    *fast = f;
    return GP_OK;
}

static void free_fragments(GpFast *fast)
{
    for (int i = 0; i < gp_pool_threads(fast->pool); i++) {
        gp_free(fast->fragments[i]);
        fast->fragments[i] = NULL;
    }
}

void gp_fast_destroy(GpFast **fast)
{
    if (!*fast)
        return;
    free_fragments(*fast);
    gp_free((*fast)->fragments);
    for (int i = 0; i < gp_pool_threads((*fast)->pool); i++)
        gp_free((*fast)->tiles[i]);
    gp_free((*fast)->tiles);
    fast_arena_free(&(*fast)->arena);
    for (uint32_t i = 0; i < (*fast)->range_room; i++)
        fast_range_free(&(*fast)->ranges[i]);
    free((*fast)->ranges);
    gp_pool_destroy(&(*fast)->pool);
    gp_free(*fast);
    *fast = NULL;
}

int gp_fast_threads(const GpFast *fast)
{
    return gp_pool_threads(fast->pool);
}

void gp_fast_set_limit(GpFast *fast, size_t bytes)
{
    fast->limit = bytes;
}

static const FastStages *const all_stages[] = {
#ifdef GP_LANES4_ISA
    &fast_stages4,
#endif
#ifdef GP_LANES8_ISA
    &fast_stages8,
#endif
#ifdef GP_LANES16_ISA
    &fast_stages16,
#endif
};

/* The stages of a width that this build has. */
static const FastStages *find_stages(int lanes)
{
    size_t i = 0;
    while (i < GP_COUNT(all_stages) && all_stages[i]->lanes != lanes)
        i++;
    GP_ASSERT(i < GP_COUNT(all_stages));
    return all_stages[i];
}

/* What earlier lists left behind: nothing of it where they ran in another width. */
static void start_workers(GpFast *fast, const FastStages *stages, bool timed)
{
    for (int i = 0; i < gp_pool_threads(fast->pool) && fast->tiles[i]; i++) {
        if (fast->lanes == stages->lanes) {
            stages->start_counting(fast->tiles[i]);
        } else {
            gp_free(fast->tiles[i]);
            fast->tiles[i] = NULL;
        }
    }
    fast->lanes = stages->lanes;
    fast->timed = timed;
}

/* The workers that a group's tiles keep busy. */
static int workers_of(const GpFast *fast, const FastGroup *group)
{
    const uint32_t tiles = group->passes[0].tiles_x * group->passes[0].tiles_y;
    const int threads = gp_pool_threads(fast->pool);
    return tiles < (uint32_t)threads ? (int)tiles : threads;
}

static bool make_tile_memory(GpFast *fast, int workers, const FastStages *stages)
{
    for (int i = 0; i < workers; i++) {
        if (fast->tiles[i])
            continue;
        fast->tiles[i] = gp_alloc(1, stages->tile_bytes());
        if (!fast->tiles[i])
            return false;
    }
    return true;
}

/* Arrays may have changed since the last list. */
static void forget_indices(GpFast *fast, const FastStages *stages)
{
    fast->indices = (GpIndexRanges){ .pool = fast->pool, .read = stages->read_indices };
}

GpResult gp_fast_check(GpFast *fast, const GpList *list, int lanes, GpError *error)
{
    forget_indices(fast, find_stages(lanes));
    return gp_list_check_again(list, &fast->programs, &fast->indices, error);
}

/* Room for the fragments of one tile a worker; false when memory is short. */
static bool make_fragment_memory(GpFast *fast, int workers, const FastStages *stages)
{
    const size_t least = stages->least_fragment_bytes(), most = FRAGMENT_BYTES;
    const size_t bytes = fast->limit < least ? least : fast->limit > most ? most : fast->limit;
    if (bytes != fast->fragment_bytes)
        free_fragments(fast);
    fast->fragment_bytes = bytes;
    for (int i = 0; i < workers; i++) {
        if (!fast->fragments[i])
            fast->fragments[i] = gp_alloc_unset(bytes);
        if (!fast->fragments[i])
            return false;
        stages->give_fragments(fast->tiles[i], fast->fragments[i], bytes);
    }
    return true;
}

static GpResult run_groups(GpFast *fast, FastCursor *at, const FastStages *stages,
                           GpCounters *counters, GpPhases *phases, GpError *error)
{
    while (at->pass < at->list->pass_count) {
        FastGroup group;
        if (!fast_prepare_group(fast, at, stages->lanes, &group))
            return gp_fail(error, GP_ERROR_MEMORY, "no memory for the vertices of a pass");
        const int workers = workers_of(fast, &group);
        if (!make_tile_memory(fast, workers, stages))
            return gp_fail(error, GP_ERROR_MEMORY, "no memory for a tile");
        if ((group.sorts || group.repeated) && !make_fragment_memory(fast, workers, stages))
            return gp_fail(error, GP_ERROR_MEMORY, "no memory for fragments that wait");
        phases->prepare += fast_clock_lap(&fast->mark);
        if (!fast_run_group(fast, &group, stages, counters, phases))
            return gp_fail(error, GP_ERROR_MEMORY, "no memory for the bins of a pass");
    }
    return GP_OK;
}

uint64_t gp_fast_memory(const GpFast *fast, const GpList *list, int lanes)
{
    return gp_fast_bytes(fast, list, find_stages(lanes)->tile_bytes(), FRAGMENT_BYTES);
}

/* Says of a list that did not get its memory how much that may be. */
static GpResult tell_memory(const GpFast *fast, const GpList *list, int lanes, GpError *error)
{
    const GpError reason = *error;
    return gp_fail(error, GP_ERROR_MEMORY, "%.200s: the list may take up to %.0f MB", reason.text,
                   (double)gp_fast_memory(fast, list, lanes) / (1 << 20));
}

GpResult gp_fast_run(GpFast *fast, const GpList *list, int lanes, bool timed, GpCounters *counters,
                     GpPhases *phases, GpError *error)
{
    const FastStages *stages = find_stages(lanes);
    fast->mark = fast_clock_ms();
    uint32_t *group_of = gp_alloc(list->pass_count, sizeof *group_of);
    if (!group_of)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for groups of passes");
    gp_list_groups(list, group_of);
    FastCursor at = { .list = list, .group_of = group_of };
    start_workers(fast, stages, timed);
    GpResult result = run_groups(fast, &at, stages, counters, phases, error);
    if (result && error)
        result = tell_memory(fast, list, lanes, error);
    for (int i = 0; i < gp_pool_threads(fast->pool) && fast->tiles[i]; i++)
        stages->add_counts(fast->tiles[i], counters, phases);
    gp_free(group_of);
    forget_indices(fast, stages);
    return result;
}
