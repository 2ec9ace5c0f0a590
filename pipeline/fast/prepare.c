/* Draws, passes and groups made ready for the stages: what they need, how fragments go, room. */
#include "pipeline/fast/executor.h"
#include "pipeline/fast/draws/repeat.h"
#include "pipeline/fast/draws/sampler.h"
#include "pipeline/units/input_assembly.h"

#include <stdlib.h>
#include <string.h>

/* --- draws ------------------------------------------------------------------------------------ */

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

static FastFragmentPath choose_path(const FastDraw *d)
{
    if (!d->needs.color && !d->wants_depth)
        return FAST_NOTHING;
    if (d->sorted)
        return FAST_ORDERED;
    if (!d->needs.pixel_shader)
        return FAST_DEPTH_ONLY;
    if (!d->needs.color || d->needs.discard || d->needs.alpha_test || d->needs.shader_depth ||
        !replaces_everything(d->pass, d->draw))
        return FAST_ORDERED;
    return FAST_VISIBLE;
}

/* Only nearer fragments pass, and what survives the shader replaces all that was there. What tests
 * depth late has no path but the ordered one. */
static bool nearest_wins(const FastDraw *d)
{
    const GpState *state = &d->draw->state;
    const bool nearer = state->depth.test == GP_LESS || state->depth.test == GP_LESS_EQUAL;
    return !d->sorted && d->late_depth && nearer && state->depth.write && !d->needs.ternary &&
           !d->needs.stencil && !d->needs.shader_depth && replaces_everything(d->pass, d->draw) &&
           d->draw->geometry.primitive != GP_POINTS;
}

static bool only_adds(const FastDraw *d)
{
    const int written = gp_program_targets(d->draw->program);
    for (int t = 0; t < written && d->pass->color[t].surface; t++) {
        const GpBlend *blend = &d->draw->state.blend[t];
        if (!gp_format_info(d->pass->color[t].surface->format)->is_float ||
            blend->op != GP_BLEND_ADD || blend->src != GP_ONE || blend->dst != GP_ONE ||
            blend->alpha_op != GP_BLEND_OFF || blend->keep & 15)
            return false;
    }
    return d->needs.color;
}

static bool only_combines_bits(const FastDraw *d)
{
    const int written = gp_program_targets(d->draw->program);
    for (int t = 0; t < written && d->pass->color[t].surface; t++)
        if (!fast_is_bitwise(&d->draw->state.blend[t], d->pass->color[t].surface->format))
            return false;
    return d->needs.color;
}

/* Points whose fragments are easily taken one after the other: bits of which nothing is asked but
 * where they are; and what adds, or leaves depth alone. */
static bool packs_points(const FastDraw *d)
{
    if (d->draw->geometry.primitive != GP_POINTS || d->path != FAST_ORDERED || d->sorted ||
        d->needs.quads)
        return false;
    if (only_combines_bits(d))
        return !d->wants_depth && d->modes.sprite < 0;
    return d->only_adds || !d->needs.color;
}

/* What the shader looks at differs between triangles alone, and nothing of what it gives takes a
 * fragment away or moves it. */
static bool has_one_color(const FastDraw *d)
{
    const GpProgram *program = d->draw->program;
    return d->sorted && d->needs.pixel_shader && d->draw->geometry.primitive != GP_POINTS &&
           !(d->varyings_by[GP_PERSPECTIVE] | d->varyings_by[GP_LINEAR_SCREEN]) &&
           !program->uses_pixel && !program->samplers && !program->local_reads && !d->needs.quads &&
           !d->needs.discard && !d->needs.alpha_test && !d->needs.shader_depth &&
           !d->needs.clip_planes;
}

/* What covers the screen with what was there, and nothing else. */
static bool is_even(const FastDraw *d)
{
    enum { FEW = 2 };
    const GpProgram *program = d->draw->program;
    return d->primitive_count <= FEW && d->draw->geometry.primitive != GP_POINTS &&
           d->needs.pixel_shader && !d->wants_depth && !d->needs.varyings && !program->samplers &&
           !program->uses_pixel && !program->uses_face && !d->needs.quads && !d->needs.discard &&
           !d->needs.alpha_test && !d->needs.clip_planes;
}

/* To shade twice costs less than to keep what is shaded, where a shader makes much of little: of
 * `points` 3 % of the time and a third of the memory. Vertices of a batch are to rise, as those do
 * that no index names. */
static bool shades_again(const FastDraw *d)
{
    const int inputs = d->draw->program->input_components;
    return d->packs_points && !gp_geometry_is_indexed(&d->draw->geometry) &&
           !d->needs.clip_planes && inputs > 0 && d->modes.components > inputs;
}

/* Where nothing is left, ends are 0, not the scissor's, which may be any numbers. */
static GpRect cut_to_scissor(GpRect rect, const GpRasterState *raster)
{
    if (!raster->scissor)
        return rect;
    rect = gp_rect_common(rect, (GpRect){ raster->scissor_x0, raster->scissor_y0,
                                          raster->scissor_x1, raster->scissor_y1 });
    return gp_rect_is_empty(rect) ? (GpRect){ 0, 0, 0, 0 } : rect;
}

/* Strips, fans and short indices are spelled out, so that all that follows knows lists alone; false
 * when memory is short. */
static bool prepare_indices(FastArena *arena, FastDraw *d)
{
    const GpGeometry *geometry = &d->draw->geometry;
    const uint32_t corners = gp_primitive_corners(geometry->primitive);
    d->indices = geometry->indices;
    if (!geometry->indices16 && geometry->primitive <= GP_POINTS)
        return true;
    uint32_t *indices =
        fast_arena_take(arena, (size_t)d->primitive_count * corners * sizeof *indices);
    for (uint32_t i = 0; indices && i < d->primitive_count; i++)
        gp_assemble(geometry, i, indices + (size_t)i * corners);
    d->indices = indices;
    return indices != NULL;
}

/* Alpha that a word has no place for reads 1. */
static GpBlendFactor factor_without_alpha(GpBlendFactor factor)
{
    if (factor == GP_DEST_ALPHA)
        return GP_ONE;
    return factor == GP_INV_DEST_ALPHA || factor == GP_SRC_ALPHA_SAT ? GP_ZERO : factor;
}

static void resolve_blends(FastDraw *d)
{
    for (int t = 0; t < GP_MAX_TARGETS; t++) {
        const GpSurface *target = d->pass->color[t].surface;
        d->blend[t] = d->draw->state.blend[t];
        if (!target || target->format != GP_X8R8G8B8)
            continue;
        d->blend[t].src = factor_without_alpha(d->blend[t].src);
        d->blend[t].dst = factor_without_alpha(d->blend[t].dst);
    }
}

/* Samplers of the slots that the program reads, and none in the others; false when memory is
 * short. */
static bool prepare_samplers(FastArena *arena, FastDraw *d)
{
    unsigned read = d->draw->program->samplers | d->draw->program->vertex_samplers;
    static const FastSampler unbound[GP_MAX_SAMPLERS];
    d->samplers = unbound;
    if (!read)
        return true;
    FastSampler *samplers = fast_arena_take(arena, GP_MAX_SAMPLERS * sizeof *samplers);
    for (int i = 0; samplers && i < GP_MAX_SAMPLERS; i++)
        if (read >> i & 1)
            fast_prepare_sampler(&d->draw->textures[i], &samplers[i]);
        else
            samplers[i].sampling = FAST_UNBOUND;
    d->samplers = samplers;
    return samplers != NULL;
}

/* Whether all that a draw does is to bring words of one surface into another: unorm8 codes come
 * through floats as they were. */
static bool copies_words(const FastDraw *d, const GpPixelFacts *facts)
{
    const GpDraw *draw = d->draw;
    const GpBlend *blend = &draw->state.blend[0];
    const GpSurface *target = d->pass->color[0].surface;
    if (!facts->copied_slot || d->path != FAST_ORDERED || d->wants_depth || d->needs.alpha_test ||
        !target)
        return false;
    const GpSurface *from = draw->textures[facts->copied_slot - 1].surface;
    return from->format == GP_A8R8G8B8 && fast_is_bitwise(blend, target->format);
}

/* Whether a draw of the pass changes what depth and stencil tests look at. */
static bool writes_depth(const GpPass *pass)
{
    for (uint32_t i = 0; pass->depth.surface && i < pass->draw_count; i++)
        if (pass->draws[i].state.depth.write || pass->draws[i].state.stencil.enable)
            return true;
    return false;
}

/* Room for a draw's vertices, unless they are those of an earlier one; false when memory is
 * short. */
static bool prepare_vertices(FastArena *arena, FastDraw *d)
{
    d->stride = (uint32_t)d->modes.components;
    for (unsigned planes = d->needs.clip_planes; planes; planes &= planes - 1)
        d->stride++;
    d->stride = (d->stride + 3) & ~3u;
    if (d->first) {
        d->indices = d->first->indices;
        d->positions = d->first->positions;
        d->varyings = d->first->varyings;
        return true;
    }
    size_t room = (size_t)d->vertex_count + FAST_WIDEST; /* whole packets are stored */
    d->block_count =
        d->vertex_count / FAST_VERTEX_BLOCK + (d->vertex_count % FAST_VERTEX_BLOCK != 0);
    d->positions = fast_arena_take(arena, room * sizeof *d->positions);
    if (!d->shades_again)
        d->varyings = fast_arena_take(arena, room * d->stride * sizeof(float));
    return prepare_indices(arena, d) && d->positions && (d->varyings || d->shades_again);
}

/* All that does not ask where a draw's vertices and primitives are.
 * in   facts: of its program
 * out  d: the rest is 0 */
static void describe_draw(const FastPass *pass, const GpDraw *draw, GpPixelFacts facts, int lanes,
                          FastDraw *d)
{
    *d = (FastDraw){
        .pass = pass->pass,
        .draw = draw,
        .code = gp_program_code(draw->program, lanes),
        .needs = gp_draw_needs(pass->pass, draw, facts.varyings_read),
        .modes = gp_varying_modes(draw->program),
        .viewport = gp_viewport_resolve(&draw->viewport, pass->width, pass->height),
    };
    d->rect = cut_to_scissor(
        gp_rect_common(gp_viewport_rect(&draw->viewport, pass->width, pass->height), pass->window),
        &draw->state.raster);
    d->band = gp_guard_band(&d->viewport);
    d->wants_depth =
        d->needs.depth_test || d->needs.depth_write || d->needs.stencil || d->needs.sorted;
    d->sorted = d->needs.sorted;
    d->tests_last = d->sorted && (pass->writes_depth || !d->needs.depth_test);
    d->late_depth =
        d->tests_last || (d->needs.late_depth &&
                          (d->needs.depth_write || d->needs.stencil || d->needs.shader_depth));
    d->path = choose_path(d);
    d->nearest_wins = nearest_wins(d);
    if (d->needs.ternary)
        d->epsilon = gp_depth_code(pass->pass->depth.surface->format, draw->state.depth.epsilon);
    resolve_blends(d);
    d->only_adds = only_adds(d);
    d->packs_points = packs_points(d);
    if (d->packs_points && d->needs.ternary) /* so that what replaces is known beside its colour */
        d->late_depth = true;
    d->shades_again = shades_again(d);
    d->shown_slot = facts.copied_slot;
    d->copies_words = copies_words(d, &facts);
}

/* Whether a draw is described as another is. */
static bool is_described_as(const GpDraw *a, const GpDraw *b)
{
    return gp_draws_alike(a, b) && a->geometry.primitive == b->geometry.primitive &&
           gp_geometry_is_indexed(&a->geometry) == gp_geometry_is_indexed(&b->geometry);
}

/* What a draw shares with the one before it, in as few words. */
static void describe_as(const FastDraw *before, const GpDraw *draw, FastDraw *d)
{
    *d = *before;
    d->draw = draw;
    d->block_count = 0;
    d->positions = NULL;
    d->varyings = NULL;
    d->repeats = (FastRepeats){ 0 };
    d->repeated = 0;
}

/* Appends a draw's work to that of its pass; false when memory is short.
 * in   programs: those that were checked; first: the draw that this one seems to repeat, or NULL
 * out  d: of the pass's draws, the next */
static bool prepare_draw(FastArena *arena, GpIndexRanges *indices, FastPass *pass,
                         const GpDraw *draw, const GpCheckedPrograms *programs, int lanes,
                         FastDraw *first, FastDraw *d)
{
    if (pass->draw_count > 0 && is_described_as(d[-1].draw, draw))
        describe_as(&d[-1], draw, d);
    else
        describe_draw(pass, draw, gp_checked_facts(programs, draw->program), lanes, d);
    d->first_block = pass->block_count;
    d->first_primitive = pass->primitive_count;
    d->primitive_count = d->path == FAST_NOTHING ? 0 : gp_geometry_primitives(&draw->geometry);

    const GpIndexRange vertices = gp_index_range(indices, &draw->geometry);
    d->first_vertex = vertices.low;
    d->vertex_count = vertices.high - vertices.low + 1;
    if (!d->primitive_count)
        d->vertex_count = 0;
    d->first = first && fast_has_vertices_of(d, first) ? first : NULL;
    if (!prepare_vertices(arena, d) || !prepare_samplers(arena, d))
        return false;
    pass->block_count += d->block_count;
    pass->primitive_count += d->primitive_count;
    fast_need_varyings(d, d->needs.varyings);
    d->one_color = has_one_color(d);
    d->is_even = is_even(d);
    return true;
}

/* --- passes and groups ------------------------------------------------------------------------ */

/* Draws of a pass, and passes of a group. */
enum { MOST_DRAWS = 4096, MOST_PASSES = 1024 };

/* Few ranges make full batches of triangles; each thread should have some. */
static uint32_t range_size(uint32_t primitives, int threads)
{
    if (threads == 1)
        return FAST_MOST_IN_RANGE;
    uint32_t part = primitives / (4 * (uint32_t)threads);
    return part < FAST_LEAST_IN_RANGE  ? FAST_LEAST_IN_RANGE
           : part > FAST_MOST_IN_RANGE ? FAST_MOST_IN_RANGE
                                       : part;
}

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static bool has_room(const GpFast *fast)
{
    return fast->vertex_bytes < fast->limit;
}

/* Whether a pass's primitives and a draw's can be numbered together. */
static bool has_numbers(const FastPass *p, const GpDraw *draw)
{
    return p->primitive_count <= GP_MAX_PRIMITIVES - gp_geometry_primitives(&draw->geometry);
}

/* Whether a pixel's sorted fragments can be blended one after the other without asking whose they
 * are. */
static bool has_one_blend(const FastPass *p)
{
    const FastDraw *first = &p->draws[0];
    for (uint32_t i = 0; i < p->draw_count; i++) {
        const FastDraw *d = &p->draws[i];
        const bool tests = d->needs.depth_test || d->needs.depth_write || d->needs.stencil;
        if (!d->needs.color || (d->tests_last && tests) ||
            gp_program_targets(d->draw->program) != gp_program_targets(first->draw->program) ||
            memcmp(d->blend, first->blend, sizeof d->blend) != 0 ||
            memcmp(d->draw->state.blend_constant, first->draw->state.blend_constant,
                   sizeof d->draw->state.blend_constant) != 0)
            return false;
        for (int t = 0; t < GP_MAX_TARGETS && p->pass->color[t].surface; t++)
            if (fast_is_bitwise(&d->blend[t], p->pass->color[t].surface->format))
                return false;
    }
    return p->draw_count > 0;
}

/* Prepares a pass from the cursor on, as far as the limit allows, but one draw at least, and all of
 * a pass whose fragments are sorted; moves the cursor behind it.
 * in   group: passes before it */
static bool prepare_pass(GpFast *fast, FastCursor *at, int lanes, const FastGroup *group,
                         FastPass *p)
{
    const GpPass *pass = &at->list->passes[at->pass];
    const bool sorts = pass->order != GP_ORDER_SUBMITTED;
    *p = (FastPass){ .pass = pass,
                     .starts = at->draw == 0,
                     .writes_depth = sorts && writes_depth(pass) };
    gp_pass_size(pass, &p->width, &p->height);
    p->window = gp_pass_window(pass);
    p->tiles_x = (uint32_t)(p->window.x1 - p->window.x0 + FAST_TILE - 1) / FAST_TILE;
    p->tiles_y = (uint32_t)(p->window.y1 - p->window.y0 + FAST_TILE - 1) / FAST_TILE;
    p->first_tile =
        (uint32_t)(p->window.y0 / FAST_TILE) * p->tiles_x + (uint32_t)(p->window.x0 / FAST_TILE);
    const FastPass *repeats = p->starts ? fast_find_repeated(group, pass, lanes) : NULL;
    bool is_repeated = repeats;
    const uint32_t most = sorts ? pass->draw_count : least(pass->draw_count - at->draw, MOST_DRAWS);
    p->draws = fast_arena_take(&fast->arena, most * sizeof *p->draws);
    if (!p->draws)
        return false;
    fast->vertex_bytes += most * sizeof *p->draws;
    while (p->draw_count < most && (p->draw_count == 0 || sorts ||
                                    (has_room(fast) && has_numbers(p, &pass->draws[at->draw])))) {
        gp_prefetch_draws(pass, at->draw);
        const GpDraw *draw = &pass->draws[at->draw++];
        const size_t taken = fast->arena.taken;
        FastDraw *d = &p->draws[p->draw_count];
        if (!prepare_draw(&fast->arena, &fast->indices, p, draw, &fast->programs, lanes,
                          repeats ? &repeats->draws[p->draw_count] : NULL, d))
            return false;
        is_repeated = is_repeated && d->first;
        p->draw_count++;
        fast->vertex_bytes += fast->arena.taken - taken;
    }
    if (at->draw == pass->draw_count) {
        at->pass++;
        at->draw = 0;
        p->repeats = is_repeated ? repeats : NULL;
    }
    p->one_blend = sorts && has_one_blend(p);
    p->range_size = range_size(p->primitive_count, gp_pool_threads(fast->pool));
    p->range_count = (p->primitive_count + p->range_size - 1) / p->range_size;
    return true;
}

/* Fresh ranges for all passes of the group. */
static bool prepare_ranges(GpFast *fast, FastGroup *group)
{
    if (group->range_count > fast->range_room) {
        FastRange *ranges = realloc(fast->ranges, group->range_count * sizeof *ranges);
        if (!ranges)
            return false;
        memset(ranges + fast->range_room, 0,
               (group->range_count - fast->range_room) * sizeof *ranges);
        fast->ranges = ranges;
        fast->range_room = group->range_count;
    }
    fast->budget.limit = group->sorts ? SIZE_MAX : fast->limit;
    if (!fast_budget_left(&fast->budget)) /* what earlier frames left where this one has no use */
        for (uint32_t i = 0; i < fast->range_room; i++)
            fast_range_free(&fast->ranges[i]);
    FastRange *range = fast->ranges;
    for (uint32_t p = 0; p < group->pass_count; p++)
        for (uint32_t r = 0; r < group->passes[p].range_count; r++, range++) {
            const uint32_t size = group->passes[p].range_size;
            const uint32_t left = group->passes[p].primitive_count - r * size;
            range->budget = &fast->budget;
            range->failed = false;
            range->first = r * size;
            range->end = range->first + (left < size ? left : size);
            range->reached = group->passes[p].repeats ? range->end : range->first;
        }
    return true;
}

/* Passes of one group of the list, as many as there are slots and memory for. */
bool fast_prepare_group(GpFast *fast, FastCursor *at, int lanes, FastGroup *group)
{
    const uint32_t number = at->group_of[at->pass];
    uint32_t end = at->pass;
    while (end < at->list->pass_count && at->group_of[end] == number &&
           end - at->pass < MOST_PASSES)
        end++;
    *group = (FastGroup){ .timed = fast->timed };
    fast_arena_reset(&fast->arena);
    fast->vertex_bytes = 0;
    group->passes = fast_arena_take(&fast->arena, (end - at->pass) * sizeof *group->passes);
    if (!group->passes)
        return false;
    bool room = true;
    while (room && at->pass < end && fast_slots_add(&group->slots, &at->list->passes[at->pass])) {
        FastPass *p = &group->passes[group->pass_count];
        if (!prepare_pass(fast, at, lanes, group, p))
            return false;
        group->pass_count++;
        group->sorts = group->sorts || p->pass->order != GP_ORDER_SUBMITTED;
        p->first_block = group->block_count;
        p->first_range = group->range_count;
        group->block_count += p->block_count;
        group->range_count += p->range_count;
        room = at->draw == 0 && has_room(fast);
    }
    for (uint32_t p = 0; p < group->pass_count; p++)
        fast_slots_add_reads(&group->slots, group->passes[p].pass);
    fast_number_repeated(group);
    return prepare_ranges(fast, group);
}
