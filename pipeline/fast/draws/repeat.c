#include "pipeline/fast/draws/repeat.h"

#include <string.h>

/* --- vertices and bins ------------------------------------------------------------------------ */

static bool has_same_vertex_shader(const GpDraw *a, const GpDraw *b, int lanes)
{
    const GpProgram *one = a->program, *other = b->program;
    if (one == other)
        return !one->vertex_samplers;
    const GpVaryingModes modes = gp_varying_modes(one), others = gp_varying_modes(other);
    return gp_program_code(one, lanes)->vertex == gp_program_code(other, lanes)->vertex &&
           !(one->vertex_samplers | other->vertex_samplers) &&
           one->uniform_bytes == other->uniform_bytes &&
           !memcmp(one->inputs, other->inputs, sizeof one->inputs) &&
           modes.components == others.components && modes.flat == others.flat &&
           modes.screen == others.screen && !memcmp(modes.mode, others.mode, sizeof modes.mode);
}

/* Bytes between members may differ where nothing else does: that is a chance missed, no more. */
static bool has_same_primitives(const GpDraw *a, const GpDraw *b, int lanes)
{
    return a->geometry.primitive != GP_POINTS &&
           !memcmp(&a->geometry, &b->geometry, sizeof a->geometry) &&
           has_same_vertex_shader(a, b, lanes) &&
           !memcmp(&a->viewport, &b->viewport, sizeof a->viewport) &&
           !memcmp(&a->state.raster, &b->state.raster, sizeof a->state.raster) &&
           (a->uniforms == b->uniforms ||
            !memcmp(a->uniforms, b->uniforms, a->program->uniform_bytes));
}

static bool draws_same_primitives(const GpPass *pass, const GpPass *before, int lanes)
{
    if (pass->draw_count != before->draw_count || !pass->draw_count ||
        pass->order != GP_ORDER_SUBMITTED || before->order != GP_ORDER_SUBMITTED)
        return false;
    for (uint32_t i = 0; i < pass->draw_count; i++)
        if (!has_same_primitives(&pass->draws[i], &before->draws[i], lanes))
            return false;
    return true;
}

const FastPass *fast_find_repeated(const FastGroup *group, const GpPass *pass, int lanes)
{
    enum { LATEST = 4 };
    for (uint32_t i = 1; i <= LATEST && i <= group->pass_count; i++) {
        const FastPass *before = &group->passes[group->pass_count - i];
        if (before->starts && before->draw_count == before->pass->draw_count &&
            draws_same_primitives(pass, before->pass, lanes))
            return before->repeats ? before->repeats : before;
    }
    return NULL;
}

bool fast_has_vertices_of(const FastDraw *draw, const FastDraw *first)
{
    return draw->primitive_count == first->primitive_count &&
           draw->vertex_count == first->vertex_count && !draw->shades_again && !first->shades_again;
}

/* --- fragments -------------------------------------------------------------------------------- */

/* Draws of fewer primitives are mostly large ones, which are found quickly. */
enum { LEAST_PRIMITIVES = 32 };

/* Whether nothing but where primitives are decides on a draw's fragments, and on what its shader is
 * told of them; and all of them are shaded, in order. */
static bool has_plain_fragments(const FastDraw *d)
{
    return d->path == FAST_ORDERED && !d->sorted && !d->needs.quads && !d->needs.stencil &&
           !d->needs.ternary && !d->draw->program->uses_face && !d->copies_words &&
           d->primitive_count >= LEAST_PRIMITIVES;
}

static FastRepeats *repeats_of(FastDraw *d)
{
    return d->first ? &d->first->repeats : &d->repeats;
}

/* Those that want a depth want it of the rasterizer, biased alike. */
static void count_repeats(FastDraw *d)
{
    FastRepeats *repeats = repeats_of(d);
    if (!repeats->draws)
        repeats->depth = d->needs.depth;
    if (repeats->depth != d->needs.depth)
        return;
    repeats->draws++;
    repeats->varyings |= d->needs.varyings;
}

static void number_draw(FastGroup *group, FastDraw *d)
{
    FastRepeats *repeats = repeats_of(d);
    if (repeats->draws < 2 || repeats->depth != d->needs.depth)
        return;
    if (!repeats->number && group->repeated < FAST_REPEATED)
        repeats->number = ++group->repeated;
    if (!repeats->number)
        return;
    d->repeated = repeats->number;
    d->late_depth = d->wants_depth; /* the answer is the same, and fragments are found without it */
    d->nearest_wins = false;
    fast_need_varyings(d, repeats->varyings);
}

void fast_number_repeated(FastGroup *group)
{
    for (int numbers = 0; numbers < 2 && !group->sorts; numbers++)
        for (uint32_t p = 0; p < group->pass_count; p++)
            for (uint32_t i = 0; i < group->passes[p].draw_count; i++) {
                FastDraw *d = &group->passes[p].draws[i];
                if (!has_plain_fragments(d))
                    continue;
                if (numbers)
                    number_draw(group, d);
                else
                    count_repeats(d);
            }
}
