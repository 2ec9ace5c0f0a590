/* The three phases of a group, and how often: once, or in rounds where its bins outgrow their
 * memory. */
#include "pipeline/fast/draws/clear.h"
#include "pipeline/base/clock.h"
#include "pipeline/fast/executor.h"
#include "pipeline/fast/draws/find.h"

/* --- phases ----------------------------------------------------------------------------------- */

enum { LEAST_BLOCKS = 4, MOST_BLOCKS = 64 };

typedef struct Job {
    GpFast *fast;
    const FastStages *stages;
    FastGroup *group;
    uint32_t blocks_of_item;
    uint32_t first_range; /* those before it are drawn */
    bool again;           /* and so is a part of this one */
} Job;

/* Each thread should have some items, but few keep threads away from each other's lines of the
 * caches: a million points are shaded 8 to 15 % sooner. */
static uint32_t blocks_of_item(uint32_t blocks, int threads)
{
    const uint32_t part = blocks / (8 * (uint32_t)threads);
    return part < LEAST_BLOCKS ? LEAST_BLOCKS : part > MOST_BLOCKS ? MOST_BLOCKS : part;
}

static void shade_block(const Job *job, const FastDraw *d, uint32_t block)
{
    uint32_t first = (block - d->first_block) * FAST_VERTEX_BLOCK;
    uint32_t count = d->vertex_count - first;
    job->stages->shade_vertices(d, first, count < FAST_VERTEX_BLOCK ? count : FAST_VERTEX_BLOCK);
}

/* Some blocks in a row, of any draws: small draws have less than one each. */
static void vertex_item(void *context, uint32_t item, int worker)
{
    (void)worker;
    const Job *job = context;
    uint32_t block = item * job->blocks_of_item, left = job->group->block_count - block;
    const FastPass *pass = fast_find_pass_of_block(job->group, block);
    const FastDraw *d = &pass->draws[fast_find_block(pass, block - pass->first_block)];
    for (left = left < job->blocks_of_item ? left : job->blocks_of_item; left; left--, block++) {
        for (; block - pass->first_block == pass->block_count; d = pass->draws)
            pass++;
        while (block - pass->first_block >= d->first_block + d->block_count)
            d++;
        shade_block(job, d, block - pass->first_block);
    }
}

static void range_item(void *context, uint32_t item, int worker)
{
    (void)worker;
    const Job *job = context;
    FastRange *range = &job->fast->ranges[job->first_range + item];
    if (range->reached == range->end) /* binned in an earlier round */
        return;
    /* the first one always comes on; others wait for memory */
    if (item && !fast_budget_left(range->budget))
        return;
    const FastPass *pass = fast_find_pass_of_range(job->group, job->first_range + item);
    range->failed = !fast_range_begin(range, pass->tiles_x * pass->tiles_y);
    if (!range->failed)
        job->stages->bin_range(pass, range);
}

static void tile_item(void *context, uint32_t item, int worker)
{
    const Job *job = context;
    job->stages->draw_tile(job->group, item, job->fast->tiles[worker]);
}

/* A band of rows of passes that draw nothing. */
static void clear_item(void *context, uint32_t item, int worker)
{
    (void)worker;
    const FastGroup *group = ((const Job *)context)->group;
    const FastPass *first = &group->passes[0];
    const GpRect *window = &first->window;
    const int32_t top = window->y0 + (int32_t)item * FAST_TILE, end = top + FAST_TILE;
    const FastBox band = { window->x0, top, window->x1 - 1,
                           (end < window->y1 ? end : window->y1) - 1 };
    for (uint32_t p = 0; p < group->pass_count; p++)
        if (group->passes[p].clears)
            fast_clear_box(group->passes[p].pass, &band, false);
}

/* --- rounds ----------------------------------------------------------------------------------- */

/* Bins as much as there is memory for, which in order is what can be drawn next. Returns the first
 * range that is not binned whole, or the count of ranges. */
static uint32_t bin_ranges(Job *job)
{
    const FastRange *ranges = job->fast->ranges;
    uint32_t count = job->group->range_count, stop = job->first_range;
    gp_pool_run_in_order(job->fast->pool, count - job->first_range, range_item, job);
    while (stop < count && ranges[stop].reached == ranges[stop].end)
        stop++;
    return stop;
}

/* The ranges of a pass that repeats another are that one's while all are there: in the first
 * round. */
static FastRange *ranges_of(const Job *job, const FastPass *p)
{
    const bool others = p->repeats && !job->again;
    return job->fast->ranges + (others ? p->repeats : p)->first_range;
}

/* Gives each pass what is to be drawn of it: all before range `stop`, and what that one has. */
static void hand_out(const Job *job, uint32_t stop, GpCounters *counters)
{
    FastRange *ranges = job->fast->ranges;
    const bool some = stop < job->group->range_count && ranges[stop].reached > ranges[stop].first;
    job->group->is_whole = !job->again && stop == job->group->range_count;
    for (uint32_t i = 0; i < job->group->pass_count; i++) {
        FastPass *p = &job->group->passes[i];
        uint32_t first = p->first_range, end = first + p->range_count;
        bool is_new = !job->again || first > job->first_range;
        p->clears = p->starts && is_new && first <= stop;
        const uint32_t drawn = first > job->first_range ? first : job->first_range;
        end = end < stop + some ? end : stop + some;
        p->ready_count = drawn < end ? end - drawn : 0;
        p->ranges = p->ready_count ? ranges_of(job, p) + (drawn - first) : NULL;
        for (uint32_t r = 0; r < p->ready_count; r++)
            counters->primitives_clipped += p->ranges[r].clipped;
    }
}

/* After the first round, from now on each pass bins for itself. */
static void part_ranges(const Job *job)
{
    for (uint32_t i = 0; i < job->group->pass_count; i++) {
        const FastPass *p = &job->group->passes[i];
        for (uint32_t r = 0; p->repeats && r < p->range_count; r++) {
            FastRange *range = &job->fast->ranges[p->first_range + r];
            range->reached = range->first;
        }
    }
}

/* After a round that was short of memory: all of it for the rest of the first range that was not
 * binned whole, and for those after it.
 * in   count: ranges of the group; those behind it are left of earlier ones */
static void forget_bins(GpFast *fast, uint32_t stop, uint32_t count)
{
    for (uint32_t i = 0; i < fast->range_room; i++) {
        FastRange *range = &fast->ranges[i];
        const bool is_binned = i > stop && i < count && range->reached == range->end;
        if (is_binned)
            continue;
        if (i == stop)
            range->first = range->reached;
        range->reached = range->first;
        fast_range_free(range);
    }
}

static void draw_ready(Job *job)
{
    const FastPass *first = &job->group->passes[0];
    if (job->group->range_count)
        gp_pool_run(job->fast->pool, first->tiles_x * first->tiles_y, tile_item, job);
    else
        gp_pool_run(job->fast->pool, first->tiles_y, clear_item, job);
}

static bool run_rounds(Job *job, GpCounters *counters, GpPhases *phases)
{
    const FastRange *ranges = job->fast->ranges;
    const uint32_t count = job->group->range_count;
    for (;;) {
        uint32_t stop = bin_ranges(job);
        for (uint32_t i = 0; i < count; i++)
            if (ranges[i].failed)
                return false;
        hand_out(job, stop, counters);
        phases->bins += fast_clock_lap(&job->fast->mark);
        draw_ready(job);
        phases->tiles += fast_clock_lap(&job->fast->mark);
        if (stop == count)
            return true;
        if (!job->again)
            part_ranges(job);
        forget_bins(job->fast, stop, count);
        job->first_range = stop;
        job->again = true;
    }
}

bool fast_run_group(GpFast *fast, FastGroup *group, const FastStages *stages, GpCounters *counters,
                    GpPhases *phases)
{
    const uint32_t blocks = group->block_count;
    Job job = { .fast = fast,
                .stages = stages,
                .group = group,
                .blocks_of_item = blocks_of_item(blocks, gp_pool_threads(fast->pool)) };
    gp_pool_run(fast->pool, (blocks + job.blocks_of_item - 1) / job.blocks_of_item, vertex_item,
                &job);
    phases->vertices += fast_clock_lap(&fast->mark);
    if (!run_rounds(&job, counters, phases))
        return false;
    for (uint32_t p = 0; p < group->pass_count; p++) {
        const FastPass *pass = &group->passes[p];
        for (uint32_t i = 0; i < pass->draw_count; i++) {
            counters->vertices += pass->draws[i].vertex_count;
            counters->primitives += pass->draws[i].primitive_count;
        }
        counters->draws += pass->draw_count;
        counters->passes += pass->starts;
    }
    return true;
}
