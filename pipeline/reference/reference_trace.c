/* How the reference executor reports to a trace. */
#include "pipeline/reference/reference_draw.h"

#include "pipeline/units/blend.h"
#include "pipeline/units/fragment_order.h"
#include "pipeline/units/input_assembly.h"

#include <string.h>

/* --- the filter ------------------------------------------------------------------------------- */

static bool wants_draw(const GpReferenceDraw *d)
{
    const GpTrace *trace = d->reference->trace;
    return trace && (!trace->one_pass || trace->pass == d->pass_number) &&
           (!trace->one_draw || trace->draw == d->draw_number) &&
           (!trace->one_primitive || trace->primitive == d->primitive);
}

static bool wants_pixel(const GpReferenceDraw *d, int32_t x, int32_t y)
{
    const GpTrace *trace = d->reference->trace;
    return (!trace->one_pixel || (trace->x == x && trace->y == y)) &&
           (!trace->wants || trace->wants(trace->user, x, y));
}

bool gp_trace_wants(const GpReferenceDraw *d, int32_t x, int32_t y)
{
    return wants_draw(d) && wants_pixel(d, x, y);
}

bool gp_trace_wants_quad(const GpReferenceDraw *d, const GpQuad *quad)
{
    const int32_t right = quad->x + 1 < (int32_t)d->width ? quad->x + 1 : quad->x;
    const int32_t bottom = quad->y + 1 < (int32_t)d->height ? quad->y + 1 : quad->y;
    for (int32_t y = quad->y; y <= bottom; y++)
        for (int32_t x = quad->x; x <= right; x++)
            if (wants_pixel(d, x, y))
                return true;
    return false;
}

/* Of a pixel; x and y are -1 where it is of none. */
static GpTraceEvent new_event(const GpReferenceDraw *d, GpTraceKind kind, int32_t x, int32_t y)
{
    return (GpTraceEvent){
        .kind = kind,
        .pass = d->pass_number,
        .draw = d->draw_number,
        .primitive = d->primitive,
        .pass_name = d->pass->name,
        .draw_name = d->draw->name,
        .program_name = d->draw->program->name,
        .x = x,
        .y = y,
    };
}

static void send(const GpReferenceDraw *d, const GpTraceEvent *event)
{
    d->reference->trace->event(d->reference->trace->user, event);
}

bool gp_trace_sends(const GpReferenceDraw *d, GpTraceKind kind)
{
    return wants_draw(d) && !(d->reference->trace->without >> kind & 1);
}

/* Next pixel of a quad, from `pixel` on, that is in the mask and whose events of the kind are
 * wanted; 4 at the end. */
static int next_pixel(const GpReferenceDraw *d, GpTraceKind kind, const GpQuad *quad, unsigned mask,
                      int pixel)
{
    if (!gp_trace_sends(d, kind))
        return 4;
    while (pixel < 4 &&
           !((mask >> pixel & 1) && wants_pixel(d, quad->x + pixel % 2, quad->y + pixel / 2)))
        pixel++;
    return pixel;
}

static GpTraceEvent pixel_event(const GpReferenceDraw *d, GpTraceKind kind, const GpQuad *quad,
                                int pixel)
{
    return new_event(d, kind, quad->x + pixel % 2, quad->y + pixel / 2);
}

/* --- clears ----------------------------------------------------------------------------------- */

static bool clears_pixel(const GpPass *pass, int32_t x, int32_t y)
{
    for (uint32_t i = 0; i < gp_pass_clear_parts(pass); i++) {
        const GpRect part = gp_pass_clear_part(pass, i);
        if (x >= part.x0 && x < part.x1 && y >= part.y0 && y < part.y1)
            return true;
    }
    return false;
}

void gp_trace_clear(const GpReference *reference, const GpPass *pass, uint32_t pass_number)
{
    const GpTrace *trace = reference->trace;
    if (!trace || (trace->one_pass && trace->pass != pass_number) ||
        trace->without >> GP_TRACE_CLEAR & 1)
        return;
    if (!gp_pass_clears(pass) || (trace->one_pixel && !clears_pixel(pass, trace->x, trace->y)))
        return;
    GpTraceEvent event = { .kind = GP_TRACE_CLEAR,
                           .pass = pass_number,
                           .pass_name = pass->name,
                           .x = trace->one_pixel ? trace->x : -1,
                           .y = trace->one_pixel ? trace->y : -1 };
    event.clear.pass = pass;
    trace->event(trace->user, &event);
}

/* --- geometry --------------------------------------------------------------------------------- */

static void send_vertices(const GpReferenceDraw *d)
{
    const GpDraw *draw = d->draw;
    if (!gp_trace_sends(d, GP_TRACE_VERTEX))
        return;
    for (uint32_t i = 0; i < gp_primitive_corners(draw->geometry.primitive); i++) {
        float inputs[GP_MAX_INPUTS];
        uint32_t number = d->corner_numbers[i];
        const GpVertex *vertex = &d->vertices[number - d->first_vertex];
        gp_fetch_vertex(&draw->geometry, draw->program, number, inputs);
        GpTraceEvent event = new_event(d, GP_TRACE_VERTEX, -1, -1);
        event.vertex.vertex = number;
        event.vertex.input_components = draw->program->input_components;
        event.vertex.varying_components = draw->program->varying_components;
        event.vertex.inputs = inputs;
        event.vertex.varyings = vertex->varying;
        memcpy(event.vertex.clip, vertex->clip, sizeof event.vertex.clip);
        send(d, &event);
    }
}

static void send_clip(const GpReferenceDraw *d)
{
    if (!d->polygon || !gp_trace_sends(d, GP_TRACE_CLIP))
        return;
    GpTraceEvent event = new_event(d, GP_TRACE_CLIP, -1, -1);
    for (int i = 0; i < 3; i++)
        memcpy(event.clip.clip[i], d->vertices[d->corner_numbers[i] - d->first_vertex].clip,
               sizeof event.clip.clip[i]);
    event.clip.planes = d->polygon->planes;
    event.clip.corners = d->polygon->corners;
    _Static_assert((int)GP_TRACE_CORNERS == (int)GP_MAX_CLIPPED, "all corners have a place");
    for (int i = 0; i < d->polygon->corners; i++)
        memcpy(event.clip.corner[i], d->polygon->corner[i].clip, sizeof event.clip.corner[i]);
    const float band[] = { d->band.left, d->band.right, d->band.bottom, d->band.top };
    memcpy(event.clip.band, band, sizeof band);
    send(d, &event);
}

/* The set-up exchanged corners 1 and 2 of a counter-clockwise triangle; traces speak of them in the
 * order in which they were submitted. */
static int submitted_corner(bool front, int corner)
{
    return front || corner == 0 ? corner : 3 - corner;
}

static void set_edges(const GpTriangle *triangle, GpTraceSetup *setup)
{
    for (int i = 0; i < 3; i++) {
        const int of = submitted_corner(triangle->front, i);
        setup->a[i] = triangle->a[of];
        setup->b[i] = triangle->b[of];
        setup->c[i] = triangle->c[of];
        setup->accepts_zero[i] = triangle->accepts_zero[of];
    }
}

static void send_setup(const GpReferenceDraw *d)
{
    static const char *const reasons[] = { [GP_SETUP_DRAWN] = NULL,
                                           [GP_SETUP_ZERO_AREA] = "zero area",
                                           [GP_SETUP_CULLED] = "facing",
                                           [GP_SETUP_OUTSIDE] = "no pixel centre inside" };
    if (!d->corner || !gp_trace_sends(d, GP_TRACE_SETUP))
        return;
    GpTraceEvent event = new_event(d, GP_TRACE_SETUP, -1, -1);
    event.setup.part = d->part;
    for (int i = 0; i < 3; i++) {
        const int of = i ? d->part + i : 0; /* a fan round the first corner */
        event.setup.x[i] = d->corner[i].x;
        event.setup.y[i] = d->corner[i].y;
        event.setup.z[i] = d->corner[i].z;
        event.setup.rw[i] = d->corner[i].rw;
        gp_viewport_place(&d->viewport, d->polygon->corner[of].clip, event.setup.place[i]);
    }
    event.setup.area2 = gp_signed_area2(d->corner);
    event.setup.culled = d->setup_result != GP_SETUP_DRAWN;
    event.setup.reason = reasons[d->setup_result];
    if (d->triangle)
        set_edges(d->triangle, &event.setup);
    send(d, &event);
}

/* What a primitive went through before it came to the pixel that is watched. */
static void send_primitive(const GpReferenceDraw *d)
{
    send_vertices(d);
    send_clip(d);
    send_setup(d);
}

void gp_trace_clip(const GpReferenceDraw *d)
{
    if (!wants_draw(d) || d->reference->trace->one_pixel)
        return;
    send_vertices(d);
    send_clip(d);
}

void gp_trace_setup(const GpReferenceDraw *d)
{
    if (wants_draw(d) && !d->reference->trace->one_pixel)
        send_setup(d);
}

/* --- pixels ----------------------------------------------------------------------------------- */

void gp_trace_raster(const GpReferenceDraw *d, const GpQuad *quad)
{
    for (int i = next_pixel(d, GP_TRACE_RASTER, quad, quad->mask, 0); i < 4;
         i = next_pixel(d, GP_TRACE_RASTER, quad, quad->mask, i + 1)) {
        if (d->reference->trace->one_pixel)
            send_primitive(d);
        GpTraceEvent event = pixel_event(d, GP_TRACE_RASTER, quad, i);
        for (int e = 0; e < 3; e++)
            event.raster.edge[e] = quad->edge[submitted_corner(quad->front, e)][i];
        event.raster.front = quad->front;
        send(d, &event);
    }
}

/* The quad as it is, and as it would be linear on the screen. */
typedef struct BothWays {
    GpQuad screen;
    float quad[GP_MAX_VARYINGS][4];
} BothWays;

static void interpolate_both(const GpReferenceDraw *d, const GpQuad *quad, BothWays *both)
{
    both->screen = *quad;
    if (d->triangle)
        gp_interpolate_on_screen(d->triangle, &d->modes, &both->screen);
    memcpy(both->quad, quad->varying, sizeof both->quad);
}

void gp_trace_interpolate(const GpReferenceDraw *d, const GpQuad *quad)
{
    BothWays both;
    int i = next_pixel(d, GP_TRACE_INTERPOLATE, quad, quad->mask, 0);
    if (i < 4)
        interpolate_both(d, quad, &both);
    for (; i < 4; i = next_pixel(d, GP_TRACE_INTERPOLATE, quad, quad->mask, i + 1)) {
        float varyings[GP_MAX_VARYINGS], screen[GP_MAX_VARYINGS];
        GpTraceEvent event = pixel_event(d, GP_TRACE_INTERPOLATE, quad, i);
        for (int c = 0; c < d->modes.components; c++) {
            varyings[c] = quad->varying[c][i];
            screen[c] = both.screen.varying[c][i];
        }
        for (int k = 0; k < 3; k++) {
            const int of = submitted_corner(quad->front, k);
            event.interpolate.barycentric[k] = quad->barycentric[of][i];
            event.interpolate.screen[k] = both.screen.barycentric[of][i];
        }
        event.interpolate.depth = quad->depth[i];
        event.interpolate.components = d->modes.components;
        event.interpolate.varyings = varyings;
        event.interpolate.screen_varyings = screen;
        event.interpolate.mask = quad->mask;
        event.interpolate.quad = both.quad[0];
        send(d, &event);
    }
}

void gp_trace_texture(const GpReferenceDraw *d, const GpTextureRead *read,
                      const GpSampleReport reports[4])
{
    for (int i = next_pixel(d, GP_TRACE_TEXTURE, d->quad, d->quad->mask, 0); i < 4;
         i = next_pixel(d, GP_TRACE_TEXTURE, d->quad, d->quad->mask, i + 1)) {
        GpTraceEvent event = pixel_event(d, GP_TRACE_TEXTURE, d->quad, i);
        event.texture.slot = read->slot;
        event.texture.surface = d->draw->textures[read->slot].surface;
        for (int c = 0; c < 4; c++) {
            event.texture.coord[c] = read->coord[c * read->lanes + i];
            event.texture.texel[c] = read->texel[c * read->lanes + i];
        }
        event.texture.report = reports[i];
        send(d, &event);
    }
}

void gp_trace_pixel(const GpReferenceDraw *d, const GpQuad *quad, unsigned mask)
{
    for (int i = next_pixel(d, GP_TRACE_PIXEL, quad, mask, 0); i < 4;
         i = next_pixel(d, GP_TRACE_PIXEL, quad, mask, i + 1)) {
        GpTraceEvent event = pixel_event(d, GP_TRACE_PIXEL, quad, i);
        event.pixel.targets = gp_program_targets(d->draw->program);
        for (int t = 0; t < event.pixel.targets; t++)
            for (int c = 0; c < 4; c++)
                event.pixel.color[t][c] = quad->color[t][c][i];
        event.pixel.depth = quad->depth[i];
        event.pixel.killed = quad->killed >> i & 1;
        send(d, &event);
    }
}

static GpTraceEvent test_event(const GpReferenceDraw *d, const GpQuad *quad, int pixel,
                               const char *unit, bool passed)
{
    GpTraceEvent event = pixel_event(d, GP_TRACE_TEST, quad, pixel);
    event.test.unit = unit;
    event.test.passed = passed;
    event.test.stencil_before = event.test.stencil_after = -1;
    return event;
}

void gp_trace_test(const GpReferenceDraw *d, const GpQuad *quad, const char *unit,
                   unsigned mask_before)
{
    for (int i = next_pixel(d, GP_TRACE_TEST, quad, mask_before, 0); i < 4;
         i = next_pixel(d, GP_TRACE_TEST, quad, mask_before, i + 1)) {
        GpTraceEvent event = test_event(d, quad, i, unit, quad->mask >> i & 1);
        if (strcmp(unit, "alpha test") == 0) {
            const GpAlphaTest *alpha = &d->draw->state.alpha_test;
            event.test.compare = alpha->test;
            event.test.incoming = (double)quad->color[0][3][i];
            event.test.stored = alpha->reference / 255.0;
        }
        send(d, &event);
    }
}

void gp_trace_sort(const GpReferenceDraw *d, const GpQuad *quad, uint32_t key, uint32_t place,
                   uint32_t count)
{
    const int pixel = next_pixel(d, GP_TRACE_SORT, quad, quad->mask, 0);
    if (pixel == 4)
        return;
    GpTraceEvent event = pixel_event(d, GP_TRACE_SORT, quad, pixel);
    event.sort = (GpTraceSort){ d->pass->order, place, count, gp_order_depth(d->pass->order, key) };
    send(d, &event);
}

void gp_trace_depth_stencil(const GpReferenceDraw *d, const GpQuad *quad, unsigned mask_before)
{
    const GpStencilState *stencil = &d->draw->state.stencil;
    for (int i = next_pixel(d, GP_TRACE_TEST, quad, mask_before, 0); i < 4;
         i = next_pixel(d, GP_TRACE_TEST, quad, mask_before, i + 1)) {
        bool stencil_passed = quad->stencil_passed >> i & 1;
        if (d->needs.stencil) {
            const GpStencilFace *face =
                stencil->two_sided && !quad->front ? &stencil->back : &stencil->front;
            GpTraceEvent event = test_event(d, quad, i, "stencil", stencil_passed);
            uint8_t seen = (uint8_t)~stencil->ignore;
            event.test.compare = face->test;
            event.test.incoming = stencil->reference & seen;
            event.test.stored = quad->stencil_before[i] & seen;
            event.test.stencil_before = quad->stencil_before[i];
            event.test.stencil_after = quad->stencil_after[i];
            send(d, &event);
        }
        if (stencil_passed && (d->needs.depth_test || d->needs.depth_write)) {
            GpTraceEvent event = test_event(d, quad, i, "depth", quad->depth_passed >> i & 1);
            GpFormat format = d->pass->depth.surface->format;
            event.test.compare = d->draw->state.depth.test;
            event.test.ternary = d->draw->state.depth.ternary;
            event.test.replaced = quad->replaced >> i & 1;
            event.test.epsilon = (double)d->draw->state.depth.epsilon;
            event.test.incoming = (double)gp_depth_from_code(format, quad->depth_incoming[i]);
            event.test.stored = (double)gp_depth_from_code(format, quad->depth_stored[i]);
            event.test.incoming_code = quad->depth_incoming[i];
            event.test.stored_code = quad->depth_stored[i];
            send(d, &event);
        }
    }
}

void gp_trace_output(const GpReferenceDraw *d, const GpQuad *quad, int target, float source[4][4])
{
    const GpSurface *surface = d->pass->color[target].surface;
    for (int i = next_pixel(d, GP_TRACE_OUTPUT, quad, quad->mask, 0); i < 4;
         i = next_pixel(d, GP_TRACE_OUTPUT, quad, quad->mask, i + 1)) {
        GpTraceEvent event = pixel_event(d, GP_TRACE_OUTPUT, quad, i);
        event.output.target = target;
        event.output.surface = surface;
        event.output.blend = d->draw->state.blend[target];
        for (int c = 0; c < 4; c++) {
            event.output.source[c] = source[c][i];
            event.output.destination[c] = quad->destination[target][c][i];
            event.output.blended[c] = quad->color[target][c][i];
        }
        gp_blend_factors(&event.output.blend, d->draw->state.blend_constant, surface->format,
                         event.output.source, event.output.destination, event.output.factor);
        gp_texel_load(surface->format,
                      gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                                       (uint32_t)event.x, (uint32_t)event.y),
                      event.output.result);
        send(d, &event);
    }
}

void gp_trace_send_missed(const GpReferenceDraw *d, int32_t x, int32_t y,
                          const GpTraceMissed *missed)
{
    if (!gp_trace_sends(d, GP_TRACE_MISSED))
        return;
    GpTraceEvent event = new_event(d, GP_TRACE_MISSED, x, y);
    event.missed = *missed;
    send(d, &event);
    if (d->reference->trace->one_pixel)
        send_primitive(d);
}

void gp_trace_send_steps(const GpReferenceDraw *d, int32_t x, int32_t y, const GpTraceSteps *steps)
{
    if (!gp_trace_sends(d, GP_TRACE_STEPS))
        return;
    GpTraceEvent event = new_event(d, GP_TRACE_STEPS, x, y);
    event.steps = *steps;
    send(d, &event);
}
