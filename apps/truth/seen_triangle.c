#include "apps/truth/seen_triangle.h"

#include <math.h>
#include <string.h>

/* An edge is as near as snapped corners may bring it; a corner moves by half a step along each
 * axis. */
#define NEAR (1.0 / 256)

/* Of a depth as floats have it, from a corner on: a few of their steps. */
#define ROUNDINGS 0x1p-22

/* --- making ----------------------------------------------------------------------------------- */

SeenView seen_view(const Camera *camera, uint32_t width, uint32_t height)
{
    return (SeenView){ *camera, camera_axes(camera, (double)width / height), width, height };
}

static void find_corner(const SeenView *view, const float position[3], double corner[4])
{
    const Camera *camera = &view->camera;
    double from[3];
    for (int k = 0; k < 3; k++)
        from[k] = (double)position[k] - camera->eye[k];
    const bool is_parallel = !(camera->fovy > 0);
    const double along = vector_dot(from, view->axes.forward), w = is_parallel ? 1 : along;
    const double length = camera->far - camera->near;
    corner[0] = (vector_dot(from, view->axes.right) / view->axes.half_width + w) / 2 * view->width;
    corner[1] = (w - vector_dot(from, view->axes.up) / view->axes.half_height) / 2 * view->height;
    corner[2] = is_parallel ? (along - camera->near) / length
                            : camera->far / length * (along - camera->near);
    corner[3] = w;
}

/* Across two corners, the same but for the sign whichever comes first. */
static void find_edge(const double a[4], const double b[4], double sign, double edge[3])
{
    edge[0] = sign * (a[1] * b[3] - b[1] * a[3]);
    edge[1] = sign * (a[3] * b[0] - b[3] * a[0]);
    edge[2] = sign * (a[0] * b[1] - b[0] * a[1]);
}

static void find_box(const SeenView *view, const double corner[3][4], SeenTriangle *seen)
{
    const double size[2] = { view->width, view->height };
    seen->is_before = true;
    for (int i = 0; i < 3; i++)
        seen->is_before = seen->is_before && corner[i][3] > 0;
    for (int k = 0; k < 2; k++) {
        seen->low[k] = 0;
        seen->high[k] = size[k];
        if (!seen->is_before)
            continue;
        for (int i = 0; i < 3; i++)
            seen->at[i][k] = corner[i][k] / corner[i][3];
        const double low = fmin(seen->at[0][k], fmin(seen->at[1][k], seen->at[2][k]));
        const double high = fmax(seen->at[0][k], fmax(seen->at[1][k], seen->at[2][k]));
        seen->low[k] = fmin(fmax(low - NEAR, 0), size[k]);
        seen->high[k] = fmin(fmax(high + NEAR, 0), size[k]);
    }
}

/* Corners in an order that they have in all triangles that share them: edges are then the same to
 * the bit, and so are depths of triangles that are the same but for where they begin, or turned
 * over. */
static void sort_corners(const float (*positions)[3], const uint32_t index[3], uint32_t sorted[3])
{
    for (int i = 0; i < 3; i++) {
        int at = i;
        for (; at > 0 &&
               memcmp(positions[sorted[at - 1]], positions[index[i]], sizeof *positions) > 0;
             at--)
            sorted[at] = sorted[at - 1];
        sorted[at] = index[i];
    }
}

void seen_triangle_make(const SeenView *view, const float (*positions)[3], const uint32_t index[3],
                        SeenTriangle *seen)
{
    double corner[3][4];
    uint32_t sorted[3];
    sort_corners(positions, index, sorted);
    for (int i = 0; i < 3; i++) {
        find_corner(view, positions[sorted[i]], corner[i]);
        seen->z[i] = corner[i][2];
        seen->w[i] = corner[i][3];
    }
    find_edge(corner[1], corner[2], 1, seen->edge[0]);
    find_edge(corner[0], corner[2], -1, seen->edge[1]);
    find_edge(corner[0], corner[1], 1, seen->edge[2]);
    find_box(view, corner, seen);
}

/* --- asking ----------------------------------------------------------------------------------- */

/* A centre on an edge is inside of the triangle for which the edge runs one way. */
static bool covers(const double at[3], const double edge[3][3])
{
    int positive = 0;
    for (int i = 0; i < 3; i++) {
        const double *e = edge[i];
        const bool runs = e[0] > 0 || (e[0] == 0 && e[1] > 0);
        positive += at[i] > 0 || (at[i] == 0 && runs);
    }
    return positive == 0 || positive == 3;
}

static double to_segment(const double p[2], const double a[2], const double b[2])
{
    const double along[2] = { b[0] - a[0], b[1] - a[1] }, from[2] = { p[0] - a[0], p[1] - a[1] };
    const double square = along[0] * along[0] + along[1] * along[1];
    const double share = (from[0] * along[0] + from[1] * along[1]) / square;
    const double t = square > 0 ? fmin(fmax(share, 0), 1) : 0;
    return hypot(from[0] - t * along[0], from[1] - t * along[1]);
}

static bool is_near_edge(const SeenTriangle *seen, const double place[2], const double share[3])
{
    for (int i = 0; i < 3; i++) {
        const double *e = seen->edge[i];
        if (fabs(share[i]) > NEAR * hypot(e[0], e[1]))
            continue;
        if (!seen->is_before ||
            to_segment(place, seen->at[(i + 1) % 3], seen->at[(i + 2) % 3]) <= NEAR)
            return true;
    }
    return false;
}

/* Of a place inside the edges. */
static void find_depth(const SeenTriangle *seen, const double share[3], SeenAt *at)
{
    const double sum = share[0] + share[1] + share[2];
    double z = 0, w = 0, slope[2];
    for (int i = 0; i < 3; i++) {
        z += share[i] * seen->z[i];
        w += share[i] * seen->w[i];
    }
    if (!(w * sum >
          0)) /* shares of one sign: where that of w is another, the place is behind the eye */
        return;
    at->depth = z / w;
    for (int k = 0; k < 2; k++) {
        double of_z = 0, of_w = 0;
        for (int i = 0; i < 3; i++) {
            of_z += seen->edge[i][k] * seen->z[i];
            of_w += seen->edge[i][k] * seen->w[i];
        }
        slope[k] = (of_z - at->depth * of_w) / w;
    }
    const double by_near = NEAR * hypot(slope[0], slope[1]);
    at->is_covered = at->depth >= 0 && at->depth <= 1;
    at->is_near_edge |= fabs(at->depth) <= by_near || fabs(1 - at->depth) <= by_near;
    at->moved = NEAR / 2 * (fabs(slope[0]) + fabs(slope[1])) + ROUNDINGS;
}

void seen_triangle_at(const SeenTriangle *seen, const double place[2], SeenAt *at)
{
    double share[3];
    for (int i = 0; i < 3; i++)
        share[i] = seen->edge[i][0] * place[0] + seen->edge[i][1] * place[1] + seen->edge[i][2];
    *at = (SeenAt){ .is_near_edge = is_near_edge(seen, place, share) };
    if (covers(share, seen->edge))
        find_depth(seen, share, at);
}
