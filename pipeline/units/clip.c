/* Clipping: a triangle is cut by near, far and guard band, after Sutherland and Hodgman.
 * in: three shaded vertices in clip space; out: a convex polygon whose new corners have varyings of their
 * own. Rules R3, R10; of points R12. */
#include "pipeline/units/clip.h"

/* Limits of the band in pixels: a little inside the fixed-point range [-32768, 32768), so that the
 * rounding of a cut corner cannot leave it. */
static const float band_low = -32704.0f, band_high = 32704.0f;

GpGuardBand gp_guard_band(const GpViewport *viewport)
{
    float x = viewport->x, y = viewport->y, width = viewport->width, height = viewport->height;
    return (GpGuardBand){
        .left = (band_low - x) * 2.0f / width - 1.0f,
        .right = (band_high - x) * 2.0f / width - 1.0f,
        .bottom = 1.0f - (band_high - y) * 2.0f / height,
        .top = 1.0f - (band_low - y) * 2.0f / height,
    };
}

/* Signed distance from a plane, positive inside; any scale will do. */
static float plane_distance(const GpGuardBand *band, int plane, const float clip[4])
{
    float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
    switch (plane) {
    case GP_CLIP_LEFT:
        return x - band->left * w;
    case GP_CLIP_RIGHT:
        return band->right * w - x;
    case GP_CLIP_BOTTOM:
        return y - band->bottom * w;
    case GP_CLIP_TOP:
        return band->top * w - y;
    case GP_CLIP_NEAR:
        return z;
    default:
        return w - z;
    }
}

static bool is_number(const float clip[4])
{
    return clip[0] == clip[0] && clip[1] == clip[1] && clip[2] == clip[2] && clip[3] == clip[3];
}

/* The corner where the edge from `inside` to `outside` meets a plane. */
static void cut_edge(const GpVertex *inside, float inside_distance, const GpVertex *outside,
                     float outside_distance, int components, uint64_t flat, GpVertex *corner)
{
    float t = inside_distance / (inside_distance - outside_distance);
    for (int c = 0; c < 4; c++)
        corner->clip[c] = inside->clip[c] + t * (outside->clip[c] - inside->clip[c]);
    for (int c = 0; c < components; c++) {
        float from = inside->varying[c], to = outside->varying[c];
        corner->varying[c] = flat >> c & 1 ? from : from + t * (to - from);
    }
    corner->point_size = inside->point_size;
}

static float between(float value, float low, float high)
{
    return value < low ? low : value > high ? high : value;
}

/* Moves a corner back onto the volume where the rounding of a cut left it outside, which is far when
 * the edge went from a very large to a very small w. A function of the corner alone, so that
 * neighbours still agree. */
static void settle_corner(const GpGuardBand *band, float clip[4])
{
    float w = clip[3];
    clip[0] = between(clip[0], band->left * w, band->right * w);
    clip[1] = between(clip[1], band->bottom * w, band->top * w);
    clip[2] = between(clip[2], 0, w);
}

static void cut_polygon(const GpGuardBand *band, int plane, const GpClipPolygon *before,
                        int components, uint64_t flat, GpClipPolygon *after)
{
    after->corners = 0;
    for (int i = 0; i < before->corners; i++) {
        const GpVertex *from = &before->corner[i];
        const GpVertex *to = &before->corner[(i + 1) % before->corners];
        float from_distance = plane_distance(band, plane, from->clip);
        float to_distance = plane_distance(band, plane, to->clip);
        bool from_inside = from_distance >= 0, to_inside = to_distance >= 0;
        if (from_inside)
            after->corner[after->corners++] = *from;
        if (from_inside && !to_inside)
            cut_edge(from, from_distance, to, to_distance, components, flat,
                     &after->corner[after->corners++]);
        if (!from_inside && to_inside)
            cut_edge(to, to_distance, from, from_distance, components, flat,
                     &after->corner[after->corners++]);
    }
}

void gp_clip_triangle(const GpGuardBand *band, const GpVertex *const triangle[3], int components,
                      uint64_t flat, GpClipPolygon *polygon)
{
    /* Near and far first: where they have cut, w is positive and the other planes mean what they
     * say. */
    static const int plane_order[GP_CLIP_PLANES] = { GP_CLIP_NEAR,  GP_CLIP_FAR,    GP_CLIP_LEFT,
                                                     GP_CLIP_RIGHT, GP_CLIP_BOTTOM, GP_CLIP_TOP };
    polygon->corners = 0;
    polygon->cut = false;
    polygon->planes = 0;
    for (int i = 0; i < 3; i++)
        if (!is_number(triangle[i]->clip))
            return;

    for (int plane = 0; plane < GP_CLIP_PLANES; plane++)
        for (int i = 0; i < 3; i++)
            if (!(plane_distance(band, plane, triangle[i]->clip) >= 0))
                polygon->planes |= 1u << plane;

    polygon->corners = 3;
    for (int i = 0; i < 3; i++) {
        polygon->corner[i] = *triangle[i];
        for (int c = 0; c < components; c++) /* flat values survive the loss of the first corner */
            if (flat >> c & 1)
                polygon->corner[i].varying[c] = triangle[0]->varying[c];
    }
    for (int i = 0; i < GP_CLIP_PLANES && polygon->corners; i++)
        if (polygon->planes >> plane_order[i] & 1) {
            GpClipPolygon before = *polygon;
            cut_polygon(band, plane_order[i], &before, components, flat, polygon);
            polygon->cut = true;
        }

    for (int i = 0; i < polygon->corners; i++)
        if (!is_number(polygon->corner[i].clip) || !(polygon->corner[i].clip[3] > 0)) {
            polygon->corners = 0;
            return;
        }
    for (int i = 0; polygon->cut && i < polygon->corners; i++)
        settle_corner(band, polygon->corner[i].clip);
}

bool gp_clip_point(const GpVertex *vertex)
{
    const float *clip = vertex->clip;
    return is_number(clip) && clip[2] >= 0 && clip[2] <= clip[3] && clip[3] > 0;
}
