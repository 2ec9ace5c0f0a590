/* Viewport: clip space becomes pixels, snapped to 1/256, and depth; the implicit scissor.
 * in: clip positions with w > 0; out: screen vertices. Rules R1, R2, R11, R14, R17. */
#include "pipeline/units/viewport.h"

#include <math.h>

GpViewport gp_viewport_resolve(const GpViewport *viewport, uint32_t width, uint32_t height)
{
    GpViewport v = *viewport;
    if (v.width == 0 && v.height == 0) {
        v.width = (float)width;
        v.height = (float)height;
    }
    if (v.min_depth == 0 && v.max_depth == 0 && !v.has_depth_range)
        v.max_depth = 1;
    v.min_depth += 0.0f; /* -0 is 0 */
    v.max_depth += 0.0f;
    if (v.d3d9_centers) {
        v.x += 0.5f;
        v.y += 0.5f;
    }
    return v;
}

static int32_t floor_within(float value, uint32_t limit)
{
    float low = floorf(value);
    return low < 0 ? 0 : low > (float)limit ? (int32_t)limit : (int32_t)low;
}

GpRect gp_viewport_rect(const GpViewport *viewport, uint32_t width, uint32_t height)
{
    GpViewport v = *viewport;
    v.d3d9_centers = false; /* a shift of the samples, not of the window */
    v = gp_viewport_resolve(&v, width, height);
    return (GpRect){ floor_within(v.x, width), floor_within(v.y, height),
                     floor_within(v.x + v.width, width), floor_within(v.y + v.height, height) };
}

void gp_viewport_place(const GpViewport *viewport, const float clip[4], float place[2])
{
    float rw = 1.0f / clip[3];
    place[0] = (clip[0] * rw + 1.0f) * viewport->width * 0.5f + viewport->x;
    place[1] = (1.0f - clip[1] * rw) * viewport->height * 0.5f + viewport->y;
}

bool gp_viewport_position(const GpViewport *viewport, const float clip[4], GpScreenVertex *screen)
{
    float rw = 1.0f / clip[3], place[2];
    gp_viewport_place(viewport, clip, place);
    float x = place[0], y = place[1];
    screen->z = viewport->min_depth + clip[2] * rw * (viewport->max_depth - viewport->min_depth);
    screen->rw = rw;
    const float range = gp_viewport_range(viewport);
    if (!(fabsf(x) < range && fabsf(y) < range))
        return false;
    screen->x = gp_snap(x);
    screen->y = gp_snap(y);
    return true;
}

bool gp_viewport_transform(const GpViewport *viewport, const GpRasterState *raster,
                           const GpVertex *vertex, GpScreenVertex *screen)
{
    const float *clip = vertex->clip;
    screen->varying = vertex->varying;
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++) {
        const float *plane = raster->clip_plane[i];
        screen->clip_distance[i] =
            clip[0] * plane[0] + clip[1] * plane[1] + clip[2] * plane[2] + clip[3] * plane[3];
    }
    return gp_viewport_position(viewport, clip, screen);
}
