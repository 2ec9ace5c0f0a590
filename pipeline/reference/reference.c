/* The reference executor: which unit follows which. Nothing is computed here but counts. */
#include "pipeline/reference/reference.h"

#include "pipeline/list/index_range.h"
#include "pipeline/reference/reference_draw.h"
#include "pipeline/shader/counts.h"
#include "pipeline/units/alpha_test.h"
#include "pipeline/units/blend.h"
#include "pipeline/units/input_assembly.h"
#include "pipeline/units/output.h"
#include "pipeline/units/raster.h"
#include "pipeline/units/scissor.h"
#include "pipeline/units/texture_read.h"

#include <string.h>

/* --- shading ---------------------------------------------------------------------------------- */

/* Serves texld and its kin for both stages; `executor` is the draw. */
static void read_texture(const GpShaderCall *call, const GpTextureRead *read)
{
    const GpReferenceDraw *d = call->executor;
    GpSampleReport reports[4];
    bool watched = d->quad && d->reference->trace;
    gp_texture_read(&call->textures[read->slot], read, d->quad ? 4 : read->lanes,
                    watched ? reports : NULL);
    if (watched)
        gp_trace_texture(d, read, reports);
}

static void shade_vertices(GpReferenceDraw *d, uint32_t count)
{
    const GpGeometry *geometry = &d->draw->geometry;
    const GpProgram *program = d->draw->program;
    uint32_t lanes = (uint32_t)d->vertex_stage.code->lanes;
    float inputs[16 * GP_MAX_INPUTS];
    for (uint32_t done = 0; done < count; done += lanes) {
        uint32_t packet = count - done < lanes ? count - done : lanes;
        for (uint32_t i = 0; i < packet; i++)
            gp_fetch_vertex(geometry, program, d->first_vertex + done + i,
                            inputs + i * program->input_components);
        gp_shade_vertices(&d->vertex_stage, inputs, (int)packet, d->vertices + done);
    }
    d->reference->counters->vertices += count;
}

/* --- from the quad to the targets ------------------------------------------------------------- */

static void write_targets(const GpReferenceDraw *d, GpQuad *quad)
{
    const GpState *state = &d->draw->state;
    for (int t = 0; t < gp_program_targets(d->draw->program); t++) {
        GpSurface *surface = d->pass->color[t].surface;
        const GpBlend *blend = &state->blend[t];
        if (!surface || (blend->keep & 15) == 15)
            continue;
        float shaded[4][4];
        memcpy(shaded, quad->color[t], sizeof shaded);
        if (state->depth.ternary)
            gp_output_clear(surface, blend->keep, quad);
        gp_output_load(surface, t, quad);
        for (int pixel = 0; pixel < 4; pixel++) {
            if (!gp_blend_reads_target(blend) || !(quad->mask >> pixel & 1))
                continue;
            float source[4], destination[4], result[4];
            for (int c = 0; c < 4; c++) {
                source[c] = quad->color[t][c][pixel];
                destination[c] = quad->destination[t][c][pixel];
            }
            gp_blend(blend, state->blend_constant, surface->format, source, destination, result);
            for (int c = 0; c < 4; c++)
                quad->color[t][c][pixel] = result[c];
        }
        gp_output_store(surface, t, blend->keep, quad);
        gp_trace_output(d, quad, t, shaded);
    }
}

static void count_pixels(uint64_t *counter, unsigned mask)
{
    *counter += (uint64_t)__builtin_popcount(mask);
}

/* Stencil, depth, blending. */
static void output_quad(GpReferenceDraw *d, GpQuad *quad)
{
    const unsigned before = quad->mask;
    if (d->needs.depth_test || d->needs.depth_write || d->needs.stencil) {
        gp_depth_stencil(&d->depth_stencil, quad);
        gp_trace_depth_stencil(d, quad, before);
    }
    count_pixels(&d->reference->counters->pixels_written, quad->mask);
    if (d->needs.color && quad->mask)
        write_targets(d, quad);
}

/* Direct3D 9's order: shader and texkill, scissor, alpha test, and what comes out of them. */
static void finish_quad(GpReferenceDraw *d, GpQuad *quad)
{
    GpCounters *counters = d->reference->counters;
    unsigned before = quad->mask;
    if (d->needs.pixel_shader) {
        const GpQuad interpolated = *quad;
        d->quad = quad;
        gp_shade_quad(&d->pixel_stage, quad);
        d->quad = NULL;
        gp_trace_steps(d, &interpolated, quad);
        count_pixels(&counters->fragments_shaded, quad->mask);
        quad->mask &= ~quad->killed;
        gp_trace_pixel(d, quad, before);
    }
    before = quad->mask;
    if (d->needs.scissor) {
        gp_scissor(&d->draw->state.raster, quad);
        gp_trace_test(d, quad, "scissor", before);
    }
    before = quad->mask;
    if (d->needs.alpha_test && d->needs.pixel_shader) {
        gp_alpha_test(&d->draw->state.alpha_test, quad);
        gp_trace_test(d, quad, "alpha test", before);
    }
    if (d->needs.sorted)
        gp_waiting_add(d->waiting, d->pass->order, quad, d->viewport.min_depth,
                       d->viewport.max_depth, d->draw_number, d->primitive);
    else
        output_quad(d, quad);
}

/* --- primitives ------------------------------------------------------------------------------- */

/* Whether a quad is drawn. */
static bool takes_quad(const GpReferenceDraw *d, const GpQuad *quad)
{
    GpHeldQuads *held = d->reference->held;
    const bool takes = !held || gp_trace_wants_quad(d, quad);
    if (held && takes)
        gp_held_add(held, quad->x, quad->y);
    return takes;
}

/* Returns whether it covers a pixel. */
static bool fill_triangle(GpReferenceDraw *d, const GpTriangle *triangle)
{
    const GpViewport *viewport = &d->viewport;
    const bool tells_all = gp_trace_sends(d, GP_TRACE_INTERPOLATE);
    GpRasterWalk walk = gp_raster_triangle(triangle);
    GpQuad quad;
    bool drawn = false;
    while (gp_raster_next(&walk, &quad)) {
        drawn = true;
        if (!takes_quad(d, &quad))
            continue;
        count_pixels(&d->reference->counters->fragments, quad.mask);
        gp_trace_raster(d, &quad);
        gp_trace_vertex_steps(d, &quad);
        gp_interpolate_barycentrics(triangle, &quad);
        unsigned before = quad.mask;
        if (d->needs.clip_planes) {
            gp_interpolate_clip(triangle, d->needs.clip_planes, &quad);
            gp_trace_test(d, &quad, "clip plane", before);
        }
        if (!quad.mask)
            continue;
        if (d->needs.depth || d->reference->trace)
            gp_interpolate_depth(triangle, viewport->min_depth, viewport->max_depth, &quad);
        gp_interpolate_varyings(triangle, &d->modes, tells_all ? ~(uint64_t)0 : d->needs.varyings,
                                &quad);
        gp_trace_interpolate(d, &quad);
        finish_quad(d, &quad);
    }
    return drawn;
}

static void draw_triangle(GpReferenceDraw *d)
{
    const GpVertex *vertex[3];
    for (int i = 0; i < 3; i++)
        vertex[i] = &d->vertices[d->corner_numbers[i] - d->first_vertex];
    GpClipPolygon polygon;
    gp_clip_triangle(&d->band, vertex,
                     &(GpClipVaryings){ d->modes.components, d->modes.flat, d->modes.screen },
                     &polygon);
    d->reference->counters->primitives_clipped += polygon.cut;
    d->polygon = &polygon;
    gp_trace_clip(d);

    GpScreenVertex screen[GP_MAX_CLIPPED];
    d->corner = NULL;
    for (int i = 0; i < polygon.corners; i++)
        if (!gp_viewport_transform(&d->viewport, &d->draw->state.raster, &polygon.corner[i],
                                   &screen[i]))
            return;
    bool drawn = false;
    for (int i = 2; i < polygon.corners; i++) { /* a fan round the first corner */
        GpScreenVertex corner[3] = { screen[0], screen[i - 1], screen[i] };
        GpTriangle triangle;
        d->corner = corner;
        d->part = i - 2;
        d->setup_result = gp_setup_triangle(corner, &d->draw->state.raster, &d->rect, &triangle);
        d->triangle = d->setup_result == GP_SETUP_DRAWN ? &triangle : NULL;
        gp_trace_setup(d);
        if (d->setup_result == GP_SETUP_DRAWN)
            drawn |= fill_triangle(d, &triangle);
        else
            gp_trace_missed_part(d);
        d->triangle = NULL;
        d->corner = NULL;
    }
    d->reference->counters->primitives_drawn += drawn;
    gp_trace_missed_clip(d);
}

static void draw_point(GpReferenceDraw *d)
{
    const GpVertex *vertex = &d->vertices[d->corner_numbers[0] - d->first_vertex];
    GpScreenVertex center;
    GpPointSprite sprite;
    if (!gp_clip_point(vertex) ||
        !gp_viewport_transform(&d->viewport, &d->draw->state.raster, vertex, &center))
        return;
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++) /* points are cut whole, by their vertex */
        if ((d->needs.clip_planes >> i & 1) && !(center.clip_distance[i] >= 0))
            return;
    if (gp_setup_point(&center, vertex->point_size, &d->rect, &sprite) != GP_SETUP_DRAWN)
        return;
    gp_trace_clip(d);

    GpRasterWalk walk = gp_raster_sprite(&sprite);
    GpQuad quad;
    memset(quad.edge, 0, sizeof quad.edge); /* a sprite has neither, but traces show them */
    memset(quad.barycentric, 0, sizeof quad.barycentric);
    while (gp_raster_next(&walk, &quad)) {
        if (!takes_quad(d, &quad))
            continue;
        count_pixels(&d->reference->counters->fragments, quad.mask);
        gp_trace_raster(d, &quad);
        gp_trace_vertex_steps(d, &quad);
        gp_interpolate_sprite(&sprite, &d->modes, d->viewport.min_depth, d->viewport.max_depth,
                              &quad);
        gp_trace_interpolate(d, &quad);
        finish_quad(d, &quad);
    }
    d->reference->counters->primitives_drawn++;
}

/* --- draws, passes, lists --------------------------------------------------------------------- */

static GpReferenceDraw begin_draw(const GpReference *reference, const GpPass *pass,
                                  const GpDraw *draw, uint64_t varyings_read, GpVertex *vertices)
{
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    const GpProgramCode *code = gp_program_code(draw->program, reference->lanes);
    GpReferenceDraw d = {
        .reference = reference,
        .pass = pass,
        .draw = draw,
        .width = width,
        .height = height,
        .needs = gp_draw_needs(pass, draw, varyings_read),
        .modes = gp_varying_modes(draw->program),
        .viewport = gp_viewport_resolve(&draw->viewport, width, height),
        .rect =
            gp_rect_common(gp_viewport_rect(&draw->viewport, width, height), gp_pass_window(pass)),
        .vertices = vertices,
    };
    d.band = gp_guard_band(&d.viewport);
    d.vertex_stage = (GpVertexStage){ .program = draw->program,
                                      .code = code,
                                      .uniforms = draw->uniforms,
                                      .textures = draw->textures,
                                      .read_texture = read_texture };
    d.pixel_stage = (GpPixelStage){ .program = draw->program,
                                    .code = code,
                                    .uniforms = draw->uniforms,
                                    .textures = draw->textures,
                                    .read_texture = read_texture,
                                    .read_local = gp_read_local_plain };
    d.depth_stencil = (GpDepthStencil){ .surface = pass->depth.surface,
                                        .depth = draw->state.depth,
                                        .stencil = draw->state.stencil,
                                        .min_depth = d.viewport.min_depth,
                                        .max_depth = d.viewport.max_depth };
    return d;
}

static uint32_t vertices_in(GpIndexRange range)
{
    return range.low > range.high ? 0 : range.high - range.low + 1;
}

static void run_draw(GpReferenceDraw *d, GpIndexRange range)
{
    const GpGeometry *geometry = &d->draw->geometry;
    uint32_t primitives = gp_geometry_primitives(geometry);
    d->first_vertex = range.low;
    d->vertex_stage.executor = d->pixel_stage.executor = d;
    shade_vertices(d, vertices_in(range));
    for (d->primitive = 0; d->primitive < primitives; d->primitive++) {
        gp_assemble(geometry, d->primitive, d->corner_numbers);
        if (geometry->primitive == GP_POINTS)
            draw_point(d);
        else
            draw_triangle(d);
    }
    d->reference->counters->primitives += primitives;
    d->reference->counters->draws++;
}

/* What has waited for the end of its pass: the fragments of each pixel in the pass's order. */
static void output_waiting(const GpReference *reference, const GpPass *pass, uint32_t pass_number,
                           GpWaiting *waiting)
{
    GpReferenceDraw d = { .draw = NULL };
    gp_waiting_sort(waiting);
    for (size_t first = 0; first < waiting->count;) {
        const uint32_t count = gp_waiting_of_pixel(waiting, first);
        for (uint32_t place = 0; place < count; place++, first++) {
            const GpWaitingFragment *fragment = &waiting->fragment[first];
            if (d.draw != &pass->draws[fragment->draw])
                d = begin_draw(reference, pass, &pass->draws[fragment->draw], 0, NULL);
            d.pass_number = pass_number;
            d.draw_number = fragment->draw;
            d.primitive = fragment->primitive;
            GpQuad quad;
            gp_waiting_quad(fragment, &quad);
            gp_trace_sort(&d, &quad, fragment->key, place, count);
            output_quad(&d, &quad);
        }
    }
    reference->counters->fragments_sorted += waiting->count;
    waiting->count = 0;
}

static void clear_part(const GpPass *pass, GpRect part)
{
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        if (pass->color[i].surface && pass->color[i].clear)
            gp_surface_clear_color_rect(pass->color[i].surface, part, pass->color[i].clear_color);
    const GpDepthTarget *depth = &pass->depth;
    if (depth->surface && (depth->clear_depth || depth->clear_stencil))
        gp_surface_clear_depth_rect(depth->surface, part, depth->depth_value, depth->stencil_value,
                                    depth->clear_depth, depth->clear_stencil);
}

static void clear_targets(const GpPass *pass)
{
    for (uint32_t i = 0; i < gp_pass_clear_parts(pass); i++)
        clear_part(pass, gp_pass_clear_part(pass, i));
}

static uint32_t most_vertices(const GpList *list, GpIndexRanges *ranges)
{
    uint32_t most = 0;
    for (uint32_t p = 0; p < list->pass_count; p++)
        for (uint32_t i = 0; i < list->passes[p].draw_count; i++) {
            const GpGeometry *geometry = &list->passes[p].draws[i].geometry;
            uint32_t count = vertices_in(gp_index_range(ranges, geometry));
            most = count > most ? count : most;
        }
    return most;
}

GpResult gp_reference_run(const GpReference *reference, const GpList *list, GpError *error)
{
    GpIndexRanges ranges = { .pool = NULL };
    uint32_t most = most_vertices(list, &ranges);
    GpVertex *vertices = gp_alloc(most, sizeof *vertices);
    if (!vertices)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %u shaded vertices", most);
    const GpProgram *program = NULL;
    uint64_t varyings_read = 0;
    GpWaiting waiting = { .fragment = NULL };
    bool untold = false;
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpPass *pass = &list->passes[p];
        const uint32_t number = reference->first_pass + p;
        clear_targets(pass);
        gp_trace_clear(reference, pass, number);
        for (uint32_t i = 0; i < pass->draw_count; i++) {
            const GpDraw *draw = &pass->draws[i];
            if (draw->program != program) { /* counting takes time: once for a run of draws */
                program = draw->program;
                varyings_read = gp_pixel_facts(program).varyings_read;
            }
            GpReferenceDraw d = begin_draw(reference, pass, draw, varyings_read, vertices);
            d.pass_number = number;
            d.draw_number = i;
            d.waiting = &waiting;
            run_draw(&d, gp_index_range(&ranges, &draw->geometry));
            untold = untold || d.untold;
        }
        output_waiting(reference, pass, number, &waiting);
        reference->counters->passes++;
    }
    gp_waiting_free(&waiting);
    gp_free(vertices);
    if (waiting.failed)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for fragments to be sorted");
    return untold ? gp_fail(error, GP_ERROR_MEMORY, "no memory for a shader's steps") : GP_OK;
}
