/* Preparing a list, drawing its frames, and their pictures. */
#include "tests/peer/bench/replay_parts.h"

#include <string.h>

static const unsigned compares[GP_COMPARES] = {
    [GP_ALWAYS] = GL_ALWAYS,      [GP_NEVER] = GL_NEVER,          [GP_LESS] = GL_LESS,
    [GP_EQUAL] = GL_EQUAL,        [GP_LESS_EQUAL] = GL_LEQUAL,    [GP_GREATER] = GL_GREATER,
    [GP_NOT_EQUAL] = GL_NOTEQUAL, [GP_GREATER_EQUAL] = GL_GEQUAL,
};

static const unsigned factors[GP_BLEND_FACTORS] = {
    [GP_ONE] = GL_ONE,
    [GP_SRC_ALPHA] = GL_SRC_ALPHA,
    [GP_INV_SRC_ALPHA] = GL_ONE_MINUS_SRC_ALPHA,
    [GP_DEST_ALPHA] = GL_DST_ALPHA,
    [GP_INV_DEST_ALPHA] = GL_ONE_MINUS_DST_ALPHA,
};

/* Whether a state holds nothing but what set_state sets. */
static bool state_is_known(const GpState *state)
{
    const GpBlend *blend = &state->blend[0];
    GpCull cull = state->raster.cull;
    return !state->stencil.enable && !state->alpha_test.test && !state->raster.scissor &&
           !state->raster.clip_planes && gp_float_bits(state->raster.depth_bias) == 0 &&
           gp_float_bits(state->raster.slope_depth_bias) == 0 && cull != GP_CULL_CCW &&
           (blend->op == GP_BLEND_OFF || blend->op == GP_BLEND_ADD) && !blend->alpha_op &&
           !blend->keep && (!blend->op || (factors[blend->src] && factors[blend->dst]));
}

/* --- preparing -------------------------------------------------------------------------------- */

/* Equal geometries share one array; the latest are the most likely. */
static GpResult find_array(Replay *r, Step *step, GpError *error)
{
    for (const Step *other = step; other > r->steps;) {
        other--;
        if (!memcmp(other->geometry, step->geometry, sizeof *step->geometry)) {
            step->array = other->array;
            return GP_OK;
        }
    }
    return replay_make_array(r->gl, step->geometry, &step->array, error);
}

static GpResult prepare_draw(Replay *r, const GpDraw *draw, Step *step, GpError *error)
{
    if (!state_is_known(&draw->state))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "a draw's state is not translated");
    step->geometry = &draw->geometry;
    GpResult result = replay_make_program(r, draw->program, &step->linked, error);
    for (int i = 0; !result && i < REPLAY_UNITS; i++) {
        if (!draw->textures[i].surface)
            continue;
        result = replay_make_texture(r, draw->textures[i].surface, error);
        if (!result)
            result = replay_set_sampler(r, &draw->textures[i], error);
    }
    return result ? result : find_array(r, step, error);
}

static GpResult prepare_pass(Replay *r, uint32_t index, Step **step, GpError *error)
{
    const GpPass *pass = &r->list->passes[index];
    GpResult result = GP_OK;
    for (int i = 0; !result && i < GP_MAX_TARGETS && pass->color[i].surface; i++)
        result = replay_make_texture(r, pass->color[i].surface, error);
    if (!result && pass->depth.surface)
        result = replay_make_texture(r, pass->depth.surface, error);
    if (!result)
        result = replay_make_framebuffer(r, index, error);
    for (uint32_t i = 0; !result && i < pass->draw_count; i++)
        result = prepare_draw(r, &pass->draws[i], (*step)++, error);
    return result;
}

GpResult replay_create(const Gl *gl, const GpList *list, Replay **replay, GpError *error)
{
    size_t draws = 0;
    for (uint32_t i = 0; i < list->pass_count; i++)
        draws += list->passes[i].draw_count;
    Replay *r = gp_alloc(1, sizeof *r);
    if (r) {
        *r = (Replay){ .gl = gl, .list = list };
        r->framebuffers = gp_alloc(list->pass_count, sizeof *r->framebuffers);
        r->steps = gp_alloc(draws, sizeof *r->steps);
    }
    if (!r || !r->framebuffers || !r->steps) {
        replay_destroy(&r);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for a list of %zu draws", draws);
    }
    gl->Disable(GL_DITHER);
    Step *step = r->steps;
    GpResult result = GP_OK;
    for (uint32_t i = 0; !result && i < list->pass_count; i++)
        result = prepare_pass(r, i, &step, error);
    gl->Finish();
    if (result)
        replay_destroy(&r);
    else
        *replay = r;
    return result;
}

void replay_destroy(Replay **replay)
{
    Replay *r = *replay;
    if (r) {
        gp_free(r->framebuffers);
        gp_free(r->steps);
    }
    gp_free(r);
    *replay = NULL;
}

/* --- the frame -------------------------------------------------------------------------------- */

static void enable(const Gl *gl, unsigned what, bool on)
{
    if (on)
        gl->Enable(what);
    else
        gl->Disable(what);
}

/* In OpenGL all targets blend alike, which is what lists of several targets do. */
static void set_state(Replay *r, const GpState *state)
{
    const Gl *gl = r->gl;
    const GpBlend *blend = &state->blend[0];
    if (r->state && !memcmp(r->state, state, sizeof *state))
        return;
    r->state = state;
    enable(gl, GL_DEPTH_TEST, state->depth.test != GP_ALWAYS || state->depth.write);
    gl->DepthFunc(compares[state->depth.test]);
    gl->DepthMask(state->depth.write);
    enable(gl, GL_CULL_FACE, state->raster.cull == GP_CULL_CW); /* y is up: OpenGL's back faces */
    enable(gl, GL_BLEND, blend->op == GP_BLEND_ADD);
    if (blend->op == GP_BLEND_ADD)
        gl->BlendFunc(factors[blend->src], factors[blend->dst]);
}

static void bind(Replay *r, int unit, const GpSurface *surface)
{
    if (r->unit[unit] == surface)
        return;
    r->gl->ActiveTexture(GL_TEXTURE0 + (unsigned)unit);
    r->gl->BindTexture(GL_TEXTURE_2D, replay_find_texture(r, surface));
    r->unit[unit] = surface;
}

/* A texture that stays bound while it is drawn to would be a loop. */
static void begin_pass(Replay *r, uint32_t index)
{
    const Gl *gl = r->gl;
    const GpPass *pass = &r->list->passes[index];
    uint32_t width, height;
    for (int i = 0; i < REPLAY_UNITS; i++)
        bind(r, i, NULL);
    gp_pass_size(pass, &width, &height);
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->framebuffers[index]);
    gl->Viewport(0, 0, (int)width, (int)height);
    for (int i = 0; i < GP_MAX_TARGETS && pass->color[i].surface; i++)
        if (pass->color[i].clear)
            gl->ClearBufferfv(GL_COLOR, i, pass->color[i].clear_color);
    if (pass->depth.surface && pass->depth.clear_depth) {
        if (r->state && !r->state->depth.write) {
            gl->DepthMask(true); /* which clearing obeys */
            r->state = NULL;
        }
        gl->ClearBufferfv(GL_DEPTH, 0, &pass->depth.depth_value);
    }
}

static void draw_step(Replay *r, const GpDraw *draw, const Step *step)
{
    const Gl *gl = r->gl;
    const GpGeometry *geometry = step->geometry;
    unsigned kind = geometry->primitive == GP_POINTS ? GL_POINTS : GL_TRIANGLES;
    if (r->now.linked != step->linked)
        gl->UseProgram(step->linked->name);
    if (r->now.array != step->array)
        gl->BindVertexArray(step->array);
    r->now = *step;
    set_state(r, &draw->state);
    replay_set_uniforms(gl, step->linked, draw->uniforms);
    for (int i = 0; i < REPLAY_UNITS; i++)
        bind(r, i, draw->textures[i].surface);
    if (geometry->indices)
        gl->DrawElements(kind, (int)geometry->index_count, GL_UNSIGNED_INT, NULL);
    else
        gl->DrawArrays(kind, 0, (int)geometry->vertex_count);
}

void replay_frame(Replay *r)
{
    const Step *step = r->steps;
    for (uint32_t p = 0; p < r->list->pass_count; p++) {
        const GpPass *pass = &r->list->passes[p];
        begin_pass(r, p);
        for (uint32_t d = 0; d < pass->draw_count; d++)
            draw_step(r, &pass->draws[d], step++);
    }
    r->gl->Finish();
}

/* --- pictures --------------------------------------------------------------------------------- */

GpResult replay_check(const Replay *r, GpError *error)
{
    unsigned problem = r->gl->GetError();
    return problem ? gp_fail(error, GP_ERROR_UNSUPPORTED, "OpenGL ES error 0x%04x", problem)
                   : GP_OK;
}

/* Reads the first target of what is bound; rows from the top. */
static void read_rows(const Gl *gl, uint32_t width, uint32_t height, uint8_t *rgba)
{
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
    for (uint32_t y = 0; y < height; y++)
        gl->ReadPixels(0, (int)(height - 1 - y), (int)width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                       rgba + (size_t)y * width * 4);
}

/* Binds a framebuffer for reading and drawing that has one texture. */
static void bind_texture_as_target(const Gl *gl, unsigned texture)
{
    unsigned framebuffer;
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl->DrawBuffers(1, &(const unsigned){ GL_COLOR_ATTACHMENT0 });
}

void replay_fetch(Replay *r, GpSurface *surface)
{
    uint8_t *texels = surface->level[0].texels;
    bind_texture_as_target(r->gl, replay_find_texture(r, surface));
    read_rows(r->gl, surface->width, surface->height, texels);
    replay_swap_red_and_blue(texels, (size_t)surface->width * surface->height, texels);
}

GpResult replay_show(Replay *r, const GpSurface *color, const GpSurface *depth, uint8_t *rgba,
                     GpError *error)
{
    static const float corners[4][3] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    static const uint32_t indices[6] = { 0, 1, 2, 0, 2, 3 };
    static const GpState plain = { .raster.cull = GP_CULL_NONE };
    static const GpGeometry screen = { .vertex_count = 4,
                                       .indices = indices,
                                       .index_count = 6,
                                       .streams = { { corners, 0, 3, GP_FLOAT32 } } };
    const Gl *gl = r->gl;
    const GpSurface *picture = color ? color : depth;
    unsigned array, program, texture;
    GpResult result = replay_make_array(gl, &screen, &array, error);
    if (!result)
        result = replay_link(gl, glsl_screen, glsl_show, &program, error);
    if (result)
        return result;
    gl->Uniform1i(gl->GetUniformLocation(program, "only_depth"), !color);
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, (int)picture->width, (int)picture->height);
    bind_texture_as_target(gl, texture);
    r->unit[0] = r->unit[1] = picture; /* neither what is bound now nor, for both, what will be */
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, replay_find_texture(r, color));
    gl->ActiveTexture(GL_TEXTURE0 + 1);
    gl->BindTexture(GL_TEXTURE_2D, replay_find_texture(r, depth));
    set_state(r, &plain);
    gl->Viewport(0, 0, (int)picture->width, (int)picture->height);
    gl->BindVertexArray(array);
    gl->DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, NULL);
    read_rows(gl, picture->width, picture->height, rgba);
    return replay_check(r, error);
}
