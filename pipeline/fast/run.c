/* Preparing passes, and the three phases of each. */
#include "pipeline/fast/fast.h"

#include "pipeline/fast/arena.h"
#include "pipeline/fast/frame.h"
#include "pipeline/fast/sampler.h"
#include "pipeline/fast/stages.h"
#include "pipeline/input_assembly.h"
#include "pipeline/pool.h"

#include <stdlib.h>
#include <string.h>

struct GpFast {
    GpPool *pool;
    FastTileMemory **tiles; /* one a worker, made when first needed */
    int lanes;              /* that they were made for */
    FastArena arena;        /* draws and shaded vertices of the pass */
    FastRange *ranges;      /* kept for the memory they hold */
    uint32_t range_room;
};

/* --- preparing ----------------------------------------------------------------------------------- */

/* A fragment that passes its tests leaves nothing of what the targets held. */
static bool replaces_everything(const GpPass *pass, const GpDraw *draw)
{
    int written = gp_program_targets(draw->program);
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        if (!pass->color[i].surface)
            break;
        if (i >= written || draw->state.blend[i].op != GP_BLEND_OFF ||
            draw->state.blend[i].keep & 15)
            return false;
    }
    return true;
}

static FastRoute choose_route(const FastDraw *d)
{
    if (!d->needs.color && !d->wants_depth)
        return FAST_NOTHING;
    if (!d->needs.pixel_shader)
        return FAST_DEPTH_ONLY;
    if (!d->needs.color || d->needs.discard || d->needs.alpha_test || d->needs.shader_depth ||
        !replaces_everything(d->pass, d->draw))
        return FAST_ORDERED;
    return FAST_VISIBLE;
}

static GpRect cut_to_scissor(GpRect rect, const GpRasterState *raster)
{
    if (!raster->scissor)
        return rect;
    rect.x0 = rect.x0 > raster->scissor_x0 ? rect.x0 : raster->scissor_x0;
    rect.y0 = rect.y0 > raster->scissor_y0 ? rect.y0 : raster->scissor_y0;
    rect.x1 = rect.x1 < raster->scissor_x1 ? rect.x1 : raster->scissor_x1;
    rect.y1 = rect.y1 < raster->scissor_y1 ? rect.y1 : raster->scissor_y1;
    return rect;
}

/* Samplers of the slots that the program reads; false when memory is short. */
static bool prepare_samplers(FastArena *arena, FastDraw *d)
{
    unsigned read = d->draw->program->samplers | d->draw->program->vertex_samplers;
    if (!read)
        return true;
    d->samplers = fast_arena_take(arena, GP_MAX_SAMPLERS * sizeof *d->samplers);
    for (int i = 0; d->samplers && i < GP_MAX_SAMPLERS; i++)
        if (read >> i & 1)
            fast_prepare_sampler(&d->draw->textures[i], &d->samplers[i]);
    return d->samplers != NULL;
}

static bool prepare_draw(FastArena *arena, FastPass *pass, const GpDraw *draw,
                         uint64_t varyings_read, int lanes, FastDraw *d)
{
    *d = (FastDraw){
        .pass = pass->pass,
        .draw = draw,
        .code = gp_program_code(draw->program, lanes),
        .needs = gp_draw_needs(pass->pass, draw, varyings_read),
        .modes = gp_varying_modes(draw->program),
        .viewport = gp_viewport_resolve(&draw->viewport, pass->width, pass->height),
        .first_block = pass->block_count,
        .first_primitive = pass->primitive_count,
        .primitive_count = gp_geometry_primitives(&draw->geometry),
    };
    d->rect = cut_to_scissor(gp_viewport_rect(&draw->viewport, pass->width, pass->height),
                             &draw->state.raster);
    d->band = gp_guard_band(&d->viewport);
    d->wants_depth = d->needs.depth_test || d->needs.depth_write || d->needs.stencil;
    d->late_depth = d->needs.late_depth;
    d->route = choose_route(d);
    if (d->route == FAST_NOTHING)
        d->primitive_count = 0;

    gp_vertex_range(&draw->geometry, &d->first_vertex, &d->vertex_count);
    if (!d->primitive_count)
        d->vertex_count = 0;
    d->stride = (uint32_t)d->modes.components;
    for (unsigned planes = d->needs.clip_planes; planes; planes &= planes - 1)
        d->stride++;
    d->stride = (d->stride + 3) & ~3u;
    size_t room = (size_t)d->vertex_count + 4; /* readers take four floats at a time */
    d->positions = fast_arena_take(arena, room * sizeof *d->positions);
    d->outside = fast_arena_take(arena, room);
    d->varyings = fast_arena_take(arena, room * d->stride * sizeof(float));
    if (draw->geometry.primitive == GP_POINTS)
        d->point_sizes = fast_arena_take(arena, room * sizeof(float));
    pass->block_count += (d->vertex_count + FAST_VERTEX_BLOCK - 1) / FAST_VERTEX_BLOCK;
    pass->primitive_count += d->primitive_count;
    return prepare_samplers(arena, d) && d->positions && d->outside && d->varyings &&
           (d->point_sizes || draw->geometry.primitive != GP_POINTS);
}

static bool prepare_ranges(GpFast *fast, FastPass *p)
{
    p->range_count = (p->primitive_count + FAST_RANGE - 1) / FAST_RANGE;
    if (p->range_count > fast->range_room) {
        FastRange *ranges = realloc(fast->ranges, p->range_count * sizeof *ranges);
        if (!ranges)
            return false;
        memset(ranges + fast->range_room, 0, (p->range_count - fast->range_room) * sizeof *ranges);
        fast->ranges = ranges;
        fast->range_room = p->range_count;
    }
    p->ranges = fast->ranges;
    return true;
}

static bool prepare_pass(GpFast *fast, const GpPass *pass, int lanes, FastPass *p)
{
    *p = (FastPass){ .pass = pass, .draw_count = pass->draw_count };
    gp_pass_size(pass, &p->width, &p->height);
    p->tiles_x = (p->width + FAST_TILE - 1) / FAST_TILE;
    p->tiles_y = (p->height + FAST_TILE - 1) / FAST_TILE;
    fast_arena_reset(&fast->arena);
    p->draws = fast_arena_take(&fast->arena, p->draw_count * sizeof *p->draws);
    if (!p->draws)
        return false;
    const GpProgram *program = NULL;
    uint64_t varyings_read = 0;
    for (uint32_t i = 0; i < p->draw_count; i++) {
        const GpDraw *draw = &pass->draws[i];
        if (draw->program != program) {
            program = draw->program;
            varyings_read = gp_varyings_read(program);
        }
        if (!prepare_draw(&fast->arena, p, draw, varyings_read, lanes, &p->draws[i]))
            return false;
    }
    return prepare_ranges(fast, p);
}

/* --- phases --------------------------------------------------------------------------------------- */

typedef struct Job {
    GpFast *fast;
    const FastPass *pass;
    const FastStages *stages;
} Job;

static void vertex_item(void *context, uint32_t item, int worker)
{
    (void)worker;
    const Job *job = context;
    const FastDraw *d = &job->pass->draws[fast_find_block(job->pass, item)];
    uint32_t first = (item - d->first_block) * FAST_VERTEX_BLOCK;
    uint32_t count = d->vertex_count - first;
    job->stages->shade_vertices(d, first, count < FAST_VERTEX_BLOCK ? count : FAST_VERTEX_BLOCK);
}

static void range_item(void *context, uint32_t item, int worker)
{
    (void)worker;
    const Job *job = context;
    const FastPass *pass = job->pass;
    FastRange *range = &pass->ranges[item];
    range->failed = !fast_range_begin(range, pass->tiles_x * pass->tiles_y);
    uint32_t first = item * FAST_RANGE, end = first + FAST_RANGE;
    if (!range->failed)
        job->stages->bin_range(pass, range, first,
                               end < pass->primitive_count ? end : pass->primitive_count);
}

static void tile_item(void *context, uint32_t item, int worker)
{
    const Job *job = context;
    job->stages->draw_tile(job->pass, item, job->fast->tiles[worker]);
}

static GpResult run_pass(GpFast *fast, const GpPass *pass, const FastStages *stages,
                         GpCounters *counters, GpError *error)
{
    FastPass p;
    GpResult result = GP_OK;
    if (!prepare_pass(fast, pass, stages->lanes, &p))
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for the vertices of a pass");
    Job job = { fast, &p, stages };
    if (result == GP_OK) {
        gp_pool_run(fast->pool, p.block_count, vertex_item, &job);
        gp_pool_run(fast->pool, p.range_count, range_item, &job);
        for (uint32_t i = 0; i < p.range_count; i++)
            if (p.ranges[i].failed)
                result = gp_fail(error, GP_ERROR_MEMORY, "no memory for the bins of a pass");
    }
    if (result == GP_OK)
        gp_pool_run(fast->pool, p.tiles_x * p.tiles_y, tile_item, &job);
    for (uint32_t i = 0; result == GP_OK && i < p.draw_count; i++) {
        counters->vertices += p.draws[i].vertex_count;
        counters->primitives += p.draws[i].primitive_count;
        counters->draws++;
    }
    for (uint32_t i = 0; result == GP_OK && i < p.range_count; i++)
        counters->primitives_clipped += p.ranges[i].clipped;
    counters->passes++;
    return result;
}

/* --- the executor ----------------------------------------------------------------------------------- */

GpResult gp_fast_create(int threads, GpFast **fast, GpError *error)
{
    GpFast *f = gp_alloc(1, sizeof *f);
    if (!f)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the fast executor");
    GpResult result = gp_pool_create(threads, &f->pool, error);
    if (result == GP_OK) {
        f->tiles = gp_alloc((size_t)threads, sizeof(FastTileMemory *));
        if (!f->tiles)
            result = gp_fail(error, GP_ERROR_MEMORY, "no memory for the fast executor");
    }
    if (result) {
        gp_pool_destroy(&f->pool);
        gp_free(f);
        return result;
    }
    *fast = f;
    return GP_OK;
}

void gp_fast_destroy(GpFast **fast)
{
    if (!*fast)
        return;
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

static GpResult make_tile_memory(GpFast *fast, const FastStages *stages, GpError *error)
{
    for (int i = 0; i < gp_pool_threads(fast->pool); i++) {
        if (fast->tiles[i] && fast->lanes == stages->lanes)
            continue;
        gp_free(fast->tiles[i]);
        fast->tiles[i] = gp_alloc(1, stages->tile_bytes());
        if (!fast->tiles[i])
            return gp_fail(error, GP_ERROR_MEMORY, "no memory for a tile");
    }
    fast->lanes = stages->lanes;
    return GP_OK;
}

GpResult gp_fast_run(GpFast *fast, const GpList *list, int lanes, GpCounters *counters,
                     GpError *error)
{
    const FastStages *stages = fast_stages(lanes);
    GpResult result = make_tile_memory(fast, stages, error);
    for (uint32_t i = 0; result == GP_OK && i < list->pass_count; i++)
        result = run_pass(fast, &list->passes[i], stages, counters, error);
    return result;
}
