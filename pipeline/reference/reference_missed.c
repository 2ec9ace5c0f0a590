/* Where triangles are not, and would have been: what a trace tells of culling and clipping.
 *
 * A triangle that was culled is set up once more with both facings. One that the near or the far
 * plane alone cut is clipped once more without these two: its vertices' z is replaced by what both
 * planes let through wherever w is positive. */
#include "pipeline/reference/reference_draw.h"

#include "pipeline/units/raster.h"

#include <math.h>

static bool is_asked(const GpReferenceDraw *d)
{
    const GpTrace *trace = d->reference->trace;
    return trace && trace->missed && (!trace->one_pass || trace->pass == d->pass_number) &&
           (!trace->one_draw || trace->draw == d->draw_number) &&
           (!trace->one_primitive || trace->primitive == d->primitive);
}

/* The pixels that may be looked at. */
static GpRect rect_of(const GpReferenceDraw *d)
{
    const GpTrace *trace = d->reference->trace;
    if (!trace->one_pixel)
        return d->rect;
    return gp_rect_common(d->rect, (GpRect){ trace->x, trace->y, trace->x + 1, trace->y + 1 });
}

static bool covers(const GpScreenVertex corner[3], const GpRasterState *state, int32_t x, int32_t y)
{
    const GpRect pixel = { x, y, x + 1, y + 1 };
    GpTriangle triangle;
    GpQuad quad;
    if (gp_setup_triangle(corner, state, &pixel, &triangle) != GP_SETUP_DRAWN)
        return false;
    GpRasterWalk walk = gp_raster_triangle(&triangle);
    return gp_raster_next(&walk, &quad);
}

/* Whether some part of what clipping left covers a pixel. */
static bool is_drawn_at(const GpReferenceDraw *d, int32_t x, int32_t y)
{
    GpScreenVertex screen[GP_MAX_CLIPPED];
    for (int i = 0; i < d->polygon->corners; i++)
        if (!gp_viewport_position(&d->viewport, d->polygon->corner[i].clip, &screen[i]))
            return false;
    for (int i = 2; i < d->polygon->corners; i++) {
        const GpScreenVertex corner[3] = { screen[0], screen[i - 1], screen[i] };
        if (covers(corner, &d->draw->state.raster, x, y))
            return true;
    }
    return false;
}

/* Tells of the pixels that a triangle would cover. */
static void tell(GpReferenceDraw *d, const GpScreenVertex corner[3], const GpRasterState *state,
                 const GpTraceMissed *missed, bool but_drawn)
{
    const GpRect rect = rect_of(d);
    GpTriangle triangle;
    GpQuad quad;
    if (gp_rect_is_empty(rect) ||
        gp_setup_triangle(corner, state, &rect, &triangle) != GP_SETUP_DRAWN)
        return;
    GpRasterWalk walk = gp_raster_triangle(&triangle);
    while (gp_raster_next(&walk, &quad)) {
        if (!gp_trace_wants_quad(d, &quad))
            continue;
        gp_interpolate_depth(&triangle, d->viewport.min_depth, d->viewport.max_depth, &quad);
        for (int i = 0; i < 4; i++) {
            const int32_t x = quad.x + i % 2, y = quad.y + i / 2;
            if (!(quad.mask >> i & 1) || !gp_trace_wants(d, x, y) ||
                (but_drawn && is_drawn_at(d, x, y)))
                continue;
            GpTraceMissed own = *missed;
            own.front = triangle.front;
            own.depth = own.has_depth ? quad.depth[i] : 0;
            gp_trace_send_missed(d, x, y, &own);
            gp_trace_vertex_steps(d, NULL);
        }
    }
}

void gp_trace_missed_part(GpReferenceDraw *d)
{
    if (!is_asked(d) || d->setup_result != GP_SETUP_CULLED)
        return;
    GpRasterState both = d->draw->state.raster;
    both.cull = GP_CULL_NONE;
    tell(d, d->corner, &both, &(GpTraceMissed){ .reason = "facing", .has_depth = true }, false);
}

static float greatest(float a, float b)
{
    return fabsf(a) > b ? fabsf(a) : b;
}

void gp_trace_missed_clip(GpReferenceDraw *d)
{
    const unsigned near = 1u << GP_CLIP_NEAR, far = 1u << GP_CLIP_FAR;
    const unsigned cut = d->polygon->planes & (near | far);
    if (!is_asked(d) || !cut || cut == (near | far))
        return;
    GpVertex copy[3];
    const GpVertex *vertex[3];
    float most = 0;
    for (int i = 0; i < 3; i++) {
        copy[i] = d->vertices[d->corner_numbers[i] - d->first_vertex];
        vertex[i] = &copy[i];
        most = greatest(copy[i].clip[3], most);
    }
    /* w is at least so much, and both planes let it through */
    for (int i = 0; i < 3; i++)
        copy[i].clip[2] = copy[i].clip[3] - most * 0x1p-16f;
    GpClipPolygon polygon;
    gp_clip_triangle(&d->band, vertex, &(GpClipVaryings){ .components = 0 }, &polygon);
    GpScreenVertex screen[GP_MAX_CLIPPED];
    for (int i = 0; i < polygon.corners; i++)
        if (!gp_viewport_position(&d->viewport, polygon.corner[i].clip, &screen[i]))
            return;
    const GpTraceMissed missed = { .reason = cut == near ? "near plane" : "far plane" };
    for (int i = 2; i < polygon.corners; i++) {
        const GpScreenVertex corner[3] = { screen[0], screen[i - 1], screen[i] };
        tell(d, corner, &d->draw->state.raster, &missed, true);
    }
}
