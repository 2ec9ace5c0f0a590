/* Clipping: a triangle is cut by near, far and guard band, after Sutherland and Hodgman.
 * in: three shaded vertices in clip space; out: a convex polygon whose new corners have varyings of
 * their own. Rules R3, R10; of points R12. */
#include "pipeline/units/clip.h"

#include <string.h>

/* Limits of the band in pixels: a little inside the fixed-point range [-32768, 32768), so that the
 * rounding of a cut corner cannot leave it. */
static const float band_low = -32704.0f, band_high = 32704.0f, margin = 64.0f;

/* A picture that is drawn by windows may end where the range does: it has a margin of its own. */
static float high_end(float end)
{
    const float within = end < GP_MAX_WHOLE ? end : GP_MAX_WHOLE;
    return within + margin > band_high ? within + margin : band_high;
}

GpGuardBand gp_guard_band(const GpViewport *viewport)
{
    float x = viewport->x, y = viewport->y, width = viewport->width, height = viewport->height;
    return (GpGuardBand){
        .left = (band_low - x) * 2.0f / width - 1.0f,
        .right = (high_end(x + width) - x) * 2.0f / width - 1.0f,
        .bottom = 1.0f - (high_end(y + height) - y) * 2.0f / height,
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

static double along(double t, double from, double to)
{
    return from + t * (to - from);
}

/* Room for one more corner; false where there is none, as a convex polygon has it. */
static bool has_room(const GpClipPolygon *polygon)
{
    return polygon->corners < GP_MAX_CLIPPED;
}

/* Adds the corner where the edge from `inside` to `outside` meets a plane. In binary64, for what is
 * left of an edge may be a hundred thousand times smaller than its ends. */
static void cut_edge(const GpClipPolygon *before, int inside, float inside_distance, int outside,
                     float outside_distance, GpClipPolygon *after)
{
    const GpVertex *from = &before->corner[inside], *to = &before->corner[outside];
    const double d = (double)inside_distance, t = d / (d - (double)outside_distance);
    GpVertex *corner = &after->corner[after->corners];
    double *share = after->share[after->corners++];
    for (int c = 0; c < 4; c++)
        corner->clip[c] = (float)along(t, (double)from->clip[c], (double)to->clip[c]);
    for (int k = 0; k < 3; k++)
        share[k] = along(t, before->share[inside][k], before->share[outside][k]);
    corner->point_size = from->point_size;
}

/* The weighted sum of a triangle's values, from the one with the greatest weight on: triangles on
 * both sides of an edge find the same, and equal values stay. */
static float weighted(const GpVertex *const triangle[3], int component, const double weight[3])
{
    const int first = weight[1] > weight[0] ? 1 : 0, most = weight[2] > weight[first] ? 2 : first;
    const double value = (double)triangle[most]->varying[component];
    double sum = value;
    for (int k = 0; k < 3; k++)
        if (k != most)
            sum += weight[k] * ((double)triangle[k]->varying[component] - value);
    return (float)sum;
}

/* Varyings of a new corner. Its place between the vertices as the screen shows them is that in clip
 * space times their w, be they behind the eye too. */
static void set_varyings(const GpVertex *const triangle[3], const GpClipVaryings *varyings,
                         const double share[3], GpVertex *corner)
{
    double screen[3], w = 0;
    for (int k = 0; k < 3; k++)
        w += screen[k] = share[k] * (double)triangle[k]->clip[3];
    for (int k = 0; k < 3; k++)
        screen[k] /= w;
    for (int c = 0; c < varyings->components; c++) {
        if (varyings->flat >> c & 1)
            corner->varying[c] = triangle[0]->varying[c];
        else
            corner->varying[c] = weighted(triangle, c, varyings->screen >> c & 1 ? screen : share);
    }
}

static float between(float value, float low, float high)
{
    return value < low ? low : value > high ? high : value;
}

/* Moves a corner back onto the volume where the rounding of a cut left it outside, which is far
 * when the edge went from a very large to a very small w. A function of the corner alone, so that
 * neighbours still agree. */
static void settle_corner(const GpGuardBand *band, float clip[4])
{
    float w = clip[3];
    clip[0] = between(clip[0], band->left * w, band->right * w);
    clip[1] = between(clip[1], band->bottom * w, band->top * w);
    clip[2] = between(clip[2], 0, w);
}

/* After all cuts. Flat values survive the loss of the first corner. */
static void finish_corner(const GpGuardBand *band, const GpVertex *const triangle[3],
                          const GpClipVaryings *varyings, const double share[3], GpVertex *corner)
{
    const bool is_new = share[0] != 1 && share[1] != 1 && share[2] != 1;
    for (int c = 0; !is_new && c < varyings->components; c++)
        if (varyings->flat >> c & 1)
            corner->varying[c] = triangle[0]->varying[c];
    if (is_new)
        set_varyings(triangle, varyings, share, corner);
    settle_corner(band, corner->clip);
}

/* Returns false where the polygon has more corners than a convex one: rounding may bend a triangle
 * without width, whose corners are of most different sizes, so that planes cut it in four
 * places. */
static bool cut_polygon(const GpGuardBand *band, int plane, const GpClipPolygon *before,
                        GpClipPolygon *after)
{
    after->corners = 0;
    for (int i = 0; i < before->corners; i++) {
        const int next = (i + 1) % before->corners;
        float distance = plane_distance(band, plane, before->corner[i].clip);
        float next_distance = plane_distance(band, plane, before->corner[next].clip);
        bool inside = distance >= 0, next_inside = next_distance >= 0;
        if (inside && !has_room(after))
            return false;
        if (inside) {
            after->corner[after->corners] = before->corner[i];
            memcpy(after->share[after->corners++], before->share[i], sizeof before->share[i]);
        }
        if (inside != next_inside && !has_room(after))
            return false;
        if (inside && !next_inside)
            cut_edge(before, i, distance, next, next_distance, after);
        if (!inside && next_inside)
            cut_edge(before, next, next_distance, i, distance, after);
    }
    return true;
}

void gp_clip_triangle(const GpGuardBand *band, const GpVertex *const triangle[3],
                      const GpClipVaryings *varyings, GpClipPolygon *polygon)
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
        for (int k = 0; k < 3; k++)
            polygon->share[i][k] = k == i;
    }
    for (int i = 0; i < GP_CLIP_PLANES && polygon->corners; i++)
        if (polygon->planes >> plane_order[i] & 1) {
            GpClipPolygon before = *polygon;
            if (!cut_polygon(band, plane_order[i], &before, polygon))
                polygon->corners = 0;
            polygon->cut = true;
        }

    for (int i = 0; i < polygon->corners; i++)
        if (!is_number(polygon->corner[i].clip) || !(polygon->corner[i].clip[3] > 0)) {
            polygon->corners = 0;
            return;
        }
    for (int i = 0; polygon->cut && i < polygon->corners; i++)
        finish_corner(band, triangle, varyings, polygon->share[i], &polygon->corner[i]);
}

bool gp_clip_point(const GpVertex *vertex)
{
    const float *clip = vertex->clip;
    return is_number(clip) && clip[2] >= 0 && clip[2] <= clip[3] && clip[3] > 0;
}
