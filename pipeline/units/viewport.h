/* Viewport: from clip space to the screen, snapped to 1/256 pixel (R1, R2, R14, R17). */
#ifndef GP_VIEWPORT_H
#define GP_VIEWPORT_H

#include "pipeline/resources/packet.h"

/* The viewport with its defaults filled in and, in Direct3D 9's mode, moved by half a pixel.
 * in   width, height: of the render targets, which an all-zero viewport covers */
GpViewport gp_viewport_resolve(const GpViewport *viewport, uint32_t width, uint32_t height);

/* The implicit scissor: the viewport's edges rounded toward negative infinity (R14), cut to the
 * target. in: as given in the draw, not resolved */
GpRect gp_viewport_rect(const GpViewport *viewport, uint32_t width, uint32_t height);

/* Where a clip-space position is in pixels, before it is snapped. in: as below; out: x, y */
void gp_viewport_place(const GpViewport *viewport, const float clip[4], float place[2]);

/* Pixels from the origin, both ways, inside which a position has its place: the fixed-point range,
 * and for pictures that reach its end, as only those do that are drawn by windows, some more. */
static inline float gp_viewport_range(const GpViewport *viewport)
{
    const float right = viewport->x + viewport->width, bottom = viewport->y + viewport->height;
    const float end = right > bottom ? right : bottom;
    const float within = end < GP_MAX_WHOLE ? end : GP_MAX_WHOLE;
    return within > 32640.0f ? within + 128.0f : 32768.0f;
}

/* One clip-space vertex to the screen.
 * in   viewport: resolved; clip: w > 0
 * out  x, y, z, rw of screen
 * returns false where x or y is no number or outside the fixed-point range */
bool gp_viewport_position(const GpViewport *viewport, const float clip[4], GpScreenVertex *screen);

/* The same for a shaded vertex, with its distances from the user planes (R11): plane . clip
 * position, summed left to right. screen->varying points into the vertex. */
bool gp_viewport_transform(const GpViewport *viewport, const GpRasterState *raster,
                           const GpVertex *vertex, GpScreenVertex *screen);

#endif
