/* Validation of a list before its first pixel: every rule once, with the field's name. */
#include "pipeline/list/list_check.h"

#include "pipeline/base/fpcontrol.h"
#include "pipeline/list/isa.h"
#include "pipeline/list/pass_target.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Where the check is, for messages. */
typedef struct Place {
    const GpList *list;
    uint32_t pass, draw;
    bool in_draw;
    int element; /* that a field's %d stands for */
    GpCheckedPrograms *programs;
    GpIndexRanges *ranges;
    GpError *error;
} Place;

__attribute__((format(printf, 3, 4))) static GpResult refuse(const Place *place, const char *field,
                                                             const char *format, ...)
{
    char where[160], place_field[64], reason[300];
    const GpPass *pass = &place->list->passes[place->pass];
    int used =
        snprintf(where, sizeof where, "pass %u '%s'", place->pass, pass->name ? pass->name : "");
    if (place->in_draw && used > 0 && (size_t)used < sizeof where) {
        const char *name = pass->draws[place->draw].name;
        snprintf(where + used, sizeof where - (size_t)used, ", draw %u '%s'", place->draw,
                 name ? name : "");
    }
    va_list args;
    snprintf(place_field, sizeof place_field, field, place->element);
    va_start(args, format);
    vsnprintf(reason, sizeof reason, format, args);
    va_end(args);
    return gp_fail(place->error, GP_ERROR_INVALID, "%s: %s: %s", where, place_field, reason);
}

static const GpPass *pass_at(const Place *place)
{
    return &place->list->passes[place->pass];
}

static const GpDraw *draw_at(const Place *place)
{
    return &pass_at(place)->draws[place->draw];
}

/* --- targets ---------------------------------------------------------------------------------- */

static GpResult check_color_targets(const Place *place)
{
    static const char field[] = "color[%d].surface";
    const GpPass *pass = pass_at(place);
    Place at = *place;
    bool ended = false;
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        const GpSurface *surface = pass->color[i].surface;
        at.element = i;
        if (surface && ended)
            return refuse(&at, field, "targets in use must be the first ones");
        ended = ended || !surface;
        if (!surface)
            continue;
        if (!gp_format_info(surface->format)->is_target)
            return refuse(&at, field, "%s is no render target format",
                          gp_format_info(surface->format)->name);
        for (int j = 0; j < i; j++)
            if (gp_surfaces_share(pass->color[j].surface, surface))
                return refuse(&at, field, "%s color[%d]",
                              pass->color[j].surface == surface ? "is also" : "shares memory with",
                              j);
    }
    return GP_OK;
}

static GpResult check_targets(const Place *place)
{
    const GpPass *pass = pass_at(place);
    GpResult result = check_color_targets(place);
    if (result)
        return result;
    const GpSurface *depth = pass->depth.surface;
    if (depth && !gp_format_info(depth->format)->is_depth)
        return refuse(place, "depth.surface", "%s is no depth format",
                      gp_format_info(depth->format)->name);
    if (!depth && !pass->color[0].surface)
        return refuse(place, "color[0].surface", "the pass has no target at all");
    if (pass->depth.clear_stencil && depth && !gp_format_info(depth->format)->has_stencil)
        return refuse(place, "depth.clear_stencil", "%s has no stencil",
                      gp_format_info(depth->format)->name);
    if (depth && pass->depth.clear_depth &&
        !(pass->depth.depth_value >= 0 && pass->depth.depth_value <= 1))
        return refuse(place, "depth.depth_value", "expected a number in [0, 1]");
    for (int i = 0; depth && i < GP_MAX_TARGETS; i++)
        if (gp_surfaces_share(pass->color[i].surface, depth))
            return refuse(place, "depth.surface", "shares memory with color[%d]", i);
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    for (int i = 0; i <= GP_MAX_TARGETS; i++) {
        const GpSurface *s = gp_pass_target(pass, i);
        if (s && (s->width != width || s->height != height))
            return refuse(place, i < GP_MAX_TARGETS ? "color" : "depth.surface",
                          "'%s' is %ux%u, but the pass is %ux%u", s->name, s->width, s->height,
                          width, height);
        if (s && !gp_rect_equal(s->window, gp_pass_window(pass)))
            return refuse(place, i < GP_MAX_TARGETS ? "color" : "depth.surface",
                          "'%s' has another window than the pass", s->name);
    }
    if (pass->clear_rect_count && !pass->clear_rects)
        return refuse(place, "clear_rects", "NULL, but clear_rect_count is %u",
                      pass->clear_rect_count);
    if (pass->clear_rect_count && !gp_pass_clears(pass))
        return refuse(place, "clear_rects", "the pass clears nothing");
    if ((unsigned)pass->order >= GP_ORDERS)
        return refuse(place, "order", "unknown");
    if (pass->draw_count && !pass->draws)
        return refuse(place, "draws", "NULL, but draw_count is %u", pass->draw_count);
    return GP_OK;
}

/* --- programs and geometry -------------------------------------------------------------------- */

/* Counting and trying one's shaders takes up to a tenth of a millisecond. */
static int find_checked(const GpCheckedPrograms *programs, const GpProgram *program)
{
    for (int i = 0; i < GP_CHECKED_PROGRAMS; i++)
        if (programs->at[i] == program &&
            memcmp(&programs->program[i], program, sizeof *program) == 0)
            return i;
    return -1;
}

GpPixelFacts gp_checked_facts(const GpCheckedPrograms *programs, const GpProgram *program)
{
    const int at = find_checked(programs, program);
    return at < 0 ? gp_pixel_facts(program) : programs->facts[at];
}

static void remember(GpCheckedPrograms *programs, const GpProgram *program)
{
    const unsigned at = programs->count++ % GP_CHECKED_PROGRAMS;
    programs->at[at] = program;
    memcpy(&programs->program[at], program, sizeof *program);
    programs->facts[at] = gp_pixel_facts(program);
}

/* Every width that may be run: each was compiled by itself. */
static GpResult try_program(const GpProgram *program, const void *uniforms, GpError *error)
{
    GpResult result = GP_OK;
    for (int i = 0; i < GP_CODE_WIDTHS && !result; i++)
        if (program->code[i] && gp_isa_runs(program->code[i]->isa))
            result = gp_program_try(program, program->code[i], uniforms, error);
    return result;
}

static bool lacks_uniforms(const GpDraw *draw)
{
    return draw->program->uniform_bytes && !draw->uniforms;
}

static GpResult check_program(const Place *place)
{
    const GpProgram *program = draw_at(place)->program;
    if (!program)
        return refuse(place, "program", "NULL");
    GpError reason;
    const bool known = find_checked(place->programs, program) >= 0;
    const GpResult checked = known ? GP_OK : gp_program_check(program, &reason);
    if (checked == GP_ERROR_MEMORY)
        return gp_fail(place->error, checked, "%s", reason.text);
    if (checked)
        return refuse(place, "program", "%s", reason.text);
    if (lacks_uniforms(draw_at(place)))
        return refuse(place, "uniforms", "NULL, but %s has %zu bytes of them", program->name,
                      program->uniform_bytes);
    if (!known && try_program(program, draw_at(place)->uniforms, &reason))
        return refuse(place, "program", "%s", reason.text);
    if (!known)
        remember(place->programs, program);
    int targets = gp_program_targets(program);
    const GpPass *pass = pass_at(place);
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        if (i < targets && !pass->color[i].surface && pass->color[0].surface)
            return refuse(place, "program", "%s writes target %d, which the pass does not have",
                          program->name, i);
    return GP_OK;
}

static GpResult check_streams(const Place *place)
{
    const GpDraw *draw = draw_at(place);
    for (size_t i = 0; i < GP_COUNT(draw->program->inputs); i++) {
        const GpInputDecl *input = &draw->program->inputs[i];
        if (!input->components)
            break;
        const GpStream *stream = &draw->geometry.streams[input->semantic];
        const bool fits = (stream->data || !draw->geometry.vertex_count) &&
                          stream->components >= 1 && stream->components <= 4 &&
                          (stream->type != GP_D3DCOLOR || stream->components == 4) &&
                          (unsigned)stream->type < GP_COMPONENT_TYPES;
        if (fits)
            continue;
        char field[64];
        snprintf(field, sizeof field, "geometry.streams[%s]", gp_semantic_names[input->semantic]);
        if (!stream->data && draw->geometry.vertex_count)
            return refuse(place, field, "not there, but %s reads it", draw->program->name);
        if (stream->components < 1 || stream->components > 4)
            return refuse(place, field, "has %d components, expected 1 to 4", stream->components);
        if (stream->type == GP_D3DCOLOR)
            return refuse(place, field, "has %d components, a D3DCOLOR has 4", stream->components);
        return refuse(place, field, "has an unknown component type");
    }
    return GP_OK;
}

static GpResult check_indices(const Place *place)
{
    const GpGeometry *geometry = &draw_at(place)->geometry;
    const bool narrow = !geometry->indices;
    if (geometry->indices && geometry->indices16)
        return refuse(place, "geometry.indices16", "there are indices of 32 bits too");
    if (!gp_geometry_is_indexed(geometry) ||
        gp_index_range(place->ranges, geometry).high < geometry->vertex_count)
        return GP_OK;
    for (uint32_t i = 0; i < geometry->index_count; i++)
        if (gp_geometry_vertex(geometry, i) >= geometry->vertex_count)
            return refuse(place, narrow ? "geometry.indices16" : "geometry.indices",
                          "index %u is %u, but there are %u vertices", i,
                          gp_geometry_vertex(geometry, i), geometry->vertex_count);
    return GP_OK;
}

static GpResult check_geometry(const Place *place)
{
    const GpGeometry *geometry = &draw_at(place)->geometry;
    if ((unsigned)geometry->primitive >= GP_PRIMITIVES)
        return refuse(place, "geometry.primitive", "unknown");
    const uint32_t used = gp_geometry_elements(geometry);
    const char *count =
        gp_geometry_is_indexed(geometry) ? "geometry.index_count" : "geometry.vertex_count";
    const bool joined =
        geometry->primitive == GP_TRIANGLE_STRIP || geometry->primitive == GP_TRIANGLE_FAN;
    if (geometry->primitive == GP_TRIANGLES && used % 3)
        return refuse(place, count, "%u is no multiple of 3", used);
    if (joined && (used == 1 || used == 2))
        return refuse(place, count, "%u of a %s make no triangle", used,
                      gp_primitive_names[geometry->primitive]);
    if (gp_geometry_primitives(geometry) > GP_MAX_PRIMITIVES)
        return refuse(place, count, "%u primitives, at most %d", gp_geometry_primitives(geometry),
                      GP_MAX_PRIMITIVES);
    const GpResult result = check_indices(place);
    return result ? result : check_streams(place);
}

/* Of a pass whose draws are right: one that sorts cannot be drawn in parts. */
static GpResult check_sorted_primitives(const Place *place)
{
    const GpPass *pass = pass_at(place);
    uint64_t primitives = 0;
    for (uint32_t d = 0; pass->order != GP_ORDER_SUBMITTED && d < pass->draw_count; d++)
        primitives += gp_geometry_primitives(&pass->draws[d].geometry);
    if (primitives <= GP_MAX_PRIMITIVES)
        return GP_OK;
    return refuse(place, "draws", "%.0f primitives in a pass that sorts, at most %d",
                  (double)primitives, GP_MAX_PRIMITIVES);
}

/* --- state ------------------------------------------------------------------------------------ */

static GpResult check_viewport(const Place *place)
{
    const GpViewport *v = &draw_at(place)->viewport;
    uint32_t width, height;
    gp_pass_size(pass_at(place), &width, &height);
    const float limit = fmaxf(2.0f * GP_MAX_SIZE, (float)(width > height ? width : height));
    if (v->width == 0 && v->height == 0 && (v->x != 0 || v->y != 0))
        return refuse(place, "viewport", "has a place but no size");
    if (!(fabsf(v->x) <= limit && fabsf(v->y) <= limit))
        return refuse(place, "viewport", "x and y must be within %g", (double)limit);
    bool whole = v->width == 0 && v->height == 0;
    if (!whole && !(v->width > 0 && v->width <= limit && v->height > 0 && v->height <= limit))
        return refuse(place, "viewport", "width and height must be in (0, %g]", (double)limit);
    if (!(v->min_depth >= 0 && v->min_depth <= 1 && v->max_depth >= 0 && v->max_depth <= 1 &&
          v->min_depth <= v->max_depth))
        return refuse(place, "viewport", "expected 0 <= min_depth <= max_depth <= 1");
    return GP_OK;
}

static GpResult check_raster_state(const Place *place)
{
    const GpRasterState *raster = &draw_at(place)->state.raster;
    if ((unsigned)raster->cull >= GP_CULLS)
        return refuse(place, "state.raster.cull", "unknown");
    if (!isfinite(raster->depth_bias) || !isfinite(raster->slope_depth_bias))
        return refuse(place, "state.raster.depth_bias", "expected finite numbers");
    if (raster->scissor &&
        (raster->scissor_x1 < raster->scissor_x0 || raster->scissor_y1 < raster->scissor_y0))
        return refuse(place, "state.raster.scissor", "ends before it begins");
    if (raster->clip_planes >> GP_MAX_CLIP_PLANES)
        return refuse(place, "state.raster.clip_planes", "only %d planes exist",
                      GP_MAX_CLIP_PLANES);
    return GP_OK;
}

static bool face_is_valid(const GpStencilFace *face)
{
    return (unsigned)face->test < GP_COMPARES && (unsigned)face->fail < GP_STENCIL_OPS &&
           (unsigned)face->depth_fail < GP_STENCIL_OPS && (unsigned)face->pass < GP_STENCIL_OPS;
}

static GpResult check_depth_state(const Place *place)
{
    const GpState *state = &draw_at(place)->state;
    const GpSurface *depth = pass_at(place)->depth.surface;
    if ((unsigned)state->depth.test >= GP_COMPARES)
        return refuse(place, "state.depth.test", "unknown");
    if ((state->depth.test != GP_ALWAYS || state->depth.write) && !depth)
        return refuse(place, "state.depth", "is on, but the pass has no depth target");
    if (!(state->depth.epsilon >= 0 && isfinite(state->depth.epsilon)))
        return refuse(place, "state.depth.epsilon", "expected a finite number from 0 on");
    if (state->depth.epsilon > 0 && !state->depth.ternary)
        return refuse(place, "state.depth.epsilon", "is of the ternary test, which is off");
    if (state->depth.ternary && (state->depth.test != GP_LESS_EQUAL || !state->depth.write))
        return refuse(place, "state.depth.ternary", "needs the test less-equal, and write");
    if ((unsigned)state->alpha_test.test >= GP_COMPARES)
        return refuse(place, "state.alpha_test.test", "unknown");
    if (!state->stencil.enable)
        return GP_OK;
    if (!depth || !gp_format_info(depth->format)->has_stencil)
        return refuse(place, "state.stencil.enable", "the pass has no stencil bits");
    if (!face_is_valid(&state->stencil.front) || !face_is_valid(&state->stencil.back))
        return refuse(place, "state.stencil", "unknown function or operation");
    return GP_OK;
}

static GpResult check_blend_state(const Place *place)
{
    static const char field[] = "state.blend[%d]";
    const GpPass *pass = pass_at(place);
    Place at = *place;
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        const GpBlend *blend = &draw_at(place)->state.blend[i];
        at.element = i;
        if ((unsigned)blend->op >= GP_BLEND_OPS || (unsigned)blend->alpha_op >= GP_BLEND_OPS ||
            (unsigned)blend->src >= GP_BLEND_FACTORS || (unsigned)blend->dst >= GP_BLEND_FACTORS ||
            (unsigned)blend->alpha_src >= GP_BLEND_FACTORS ||
            (unsigned)blend->alpha_dst >= GP_BLEND_FACTORS)
            return refuse(&at, field, "unknown operation or factor");
        if (blend->dst == GP_SRC_ALPHA_SAT || blend->alpha_dst == GP_SRC_ALPHA_SAT)
            return refuse(&at, field, "src-alpha-sat is a source factor only");
        if (blend->op == GP_BLEND_OFF && blend->alpha_op != GP_BLEND_OFF)
            return refuse(&at, field, "alpha blends, but colour does not");
        bool logic = gp_blend_is_logic(blend->op);
        if (blend->alpha_op != GP_BLEND_OFF && blend->alpha_op != blend->op &&
            (logic || gp_blend_is_logic(blend->alpha_op)))
            return refuse(&at, field, "logical operations serve colour and alpha alike");
        const GpSurface *target = pass->color[i].surface;
        if (logic && target && gp_format_info(target->format)->is_float)
            return refuse(&at, field, "logical operations need an unorm target, not %s",
                          gp_format_info(target->format)->name);
    }
    return GP_OK;
}

/* --- textures --------------------------------------------------------------------------------- */

static GpResult check_sampler(const Place *place, const char *field, const GpTexture *texture)
{
    const GpSampler *s = &texture->sampler;
    if ((unsigned)s->min >= GP_FILTERS || (unsigned)s->mag >= GP_FILTERS ||
        (unsigned)s->mip >= GP_MIP_FILTERS || (unsigned)s->address_u >= GP_ADDRESSES ||
        (unsigned)s->address_v >= GP_ADDRESSES)
        return refuse(place, field, "unknown filter or address mode");
    if (!isfinite(s->lod_bias) || !isfinite(s->min_lod) || !isfinite(s->max_lod))
        return refuse(place, field, "lod_bias, min_lod and max_lod must be finite");
    bool depth = gp_format_info(texture->surface->format)->is_depth;
    if (s->compare && !depth)
        return refuse(place, field, "compares, but %s is no depth format",
                      gp_format_info(texture->surface->format)->name);
    return GP_OK;
}

static GpResult check_textures(const Place *place)
{
    static const char field[] = "textures[%d].surface";
    const GpDraw *draw = draw_at(place);
    const GpProgram *program = draw->program;
    unsigned read = program->samplers | program->vertex_samplers | program->local_reads;
    Place at = *place;
    for (; read; read &= read - 1) {
        const int i = at.element = __builtin_ctz(read);
        const GpSurface *surface = draw->textures[i].surface;
        if (!surface)
            return refuse(&at, field, "not bound, but %s reads slot %d", program->name, i);
        if (gp_pass_renders_to(pass_at(place), surface))
            return refuse(&at, field, "'%s' is a render target of this pass", surface->name);
        GpResult result = check_sampler(&at, field, &draw->textures[i]);
        if (result)
            return result;
        if (((program->samplers | program->vertex_samplers) >> i & 1) &&
            !gp_surface_is_whole(surface))
            return refuse(&at, field, "'%s' has a window: it is read only in place", surface->name);
        uint32_t width, height;
        gp_pass_size(pass_at(place), &width, &height);
        bool local = program->local_reads >> i & 1;
        if (local && (surface->width != width || surface->height != height))
            return refuse(&at, field, "'%s' is %ux%u; read in place it must be %ux%u",
                          surface->name, surface->width, surface->height, width, height);
        const GpRect window = gp_pass_window(pass_at(place));
        if (local && !gp_rect_equal(gp_rect_common(window, surface->window), window))
            return refuse(&at, field, "'%s' has another window than the pass", surface->name);
    }
    return GP_OK;
}

/* --- the whole -------------------------------------------------------------------------------- */

bool gp_draws_alike(const GpDraw *a, const GpDraw *b)
{
    const GpProgram *program = a->program;
    return program == b->program &&
           !(program->samplers | program->vertex_samplers | program->local_reads) &&
           memcmp(&a->viewport, &b->viewport, sizeof a->viewport) == 0 &&
           memcmp(&a->state, &b->state, sizeof a->state) == 0;
}

/* Whether all but a draw's geometry is as in the one before it, which was right. */
static bool is_as_before(const Place *place)
{
    const GpDraw *draw = draw_at(place);
    return place->draw > 0 && gp_draws_alike(draw, draw - 1) && !lacks_uniforms(draw);
}

static GpResult check_draw(const Place *place)
{
    static GpResult (*const checks[])(const Place *) = {
        check_program,     check_geometry,    check_viewport, check_raster_state,
        check_depth_state, check_blend_state, check_textures,
    };
    gp_prefetch_draws(pass_at(place), place->draw);
    GpResult result = GP_OK;
    if (is_as_before(place))
        return check_geometry(place);
    for (size_t i = 0; i < GP_COUNT(checks) && !result; i++)
        result = checks[i](place);
    return result;
}

static GpResult check_list(const GpList *list, GpCheckedPrograms *programs, GpIndexRanges *ranges,
                           GpError *error)
{
    if (list->pass_count && !list->passes)
        return gp_fail(error, GP_ERROR_INVALID, "passes: NULL, but pass_count is %u",
                       list->pass_count);
    Place place = { .list = list, .programs = programs, .ranges = ranges, .error = error };
    for (place.pass = 0; place.pass < list->pass_count; place.pass++) {
        place.in_draw = false;
        GpResult result = check_targets(&place);
        if (result)
            return result;
        place.in_draw = true;
        for (place.draw = 0; place.draw < pass_at(&place)->draw_count; place.draw++) {
            result = check_draw(&place);
            if (result)
                return result;
        }
        place.in_draw = false;
        result = check_sorted_primitives(&place);
        if (result)
            return result;
    }
    return GP_OK;
}

GpResult gp_list_check_again(const GpList *list, GpCheckedPrograms *programs, GpIndexRanges *ranges,
                             GpError *error)
{
    const GpFpControl control = gp_fp_enter(); /* shaders run on trial */
    const GpResult result = check_list(list, programs, ranges, error);
    gp_fp_leave(control);
    return result;
}

GpResult gp_list_check(const GpList *list, GpError *error)
{
    GpCheckedPrograms programs = { .count = 0 };
    GpIndexRanges ranges = { .pool = NULL };
    return gp_list_check_again(list, &programs, &ranges, error);
}
