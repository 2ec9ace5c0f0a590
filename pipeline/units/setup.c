/* Set-up: facing, culling, and all that stays constant inside a triangle; squares for points.
 * in: corners in sub-pixels; out: edge functions, depth plane, factors of barycentrics, box. Exact
 * in 64-bit integers but for depth, which is binary64. Rules R2 to R5, R8, R16, R22; points R12. */
#include "pipeline/units/setup.h"

/* First pixel whose centre is at or right of (below) a coordinate, and last at or left of it. */
static int32_t first_center(int32_t fixed)
{
    return (fixed + GP_SUBPIXELS / 2 - 1) >> GP_SUBPIXEL_BITS;
}

static int32_t last_center(int32_t fixed)
{
    return (fixed - GP_SUBPIXELS / 2) >> GP_SUBPIXEL_BITS;
}

static int32_t lesser(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t greater(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

int64_t gp_signed_area2(const GpScreenVertex corner[3])
{
    int64_t x1 = corner[1].x - corner[0].x, y1 = corner[1].y - corner[0].y;
    int64_t x2 = corner[2].x - corner[0].x, y2 = corner[2].y - corner[0].y;
    return x1 * y2 - x2 * y1;
}

/* Edge i runs from corner i+1 to corner i+2. With y down and corners clockwise, a top edge goes
 * exactly right, a left edge goes up. */
static void set_edges(GpTriangle *t)
{
    for (int i = 0; i < 3; i++) {
        const GpScreenVertex *from = &t->corner[(i + 1) % 3], *to = &t->corner[(i + 2) % 3];
        int64_t dx = to->x - from->x, dy = to->y - from->y;
        t->a[i] = -dy;
        t->b[i] = dx;
        t->c[i] = dy * from->x - dx * from->y;
        t->accepts_zero[i] = dy < 0 || (dy == 0 && dx > 0);
    }
}

static bool set_box(GpTriangle *t, const GpRect *rect)
{
    const GpScreenVertex *v = t->corner;
    t->x0 = greater(first_center(lesser(v[0].x, lesser(v[1].x, v[2].x))), rect->x0);
    t->y0 = greater(first_center(lesser(v[0].y, lesser(v[1].y, v[2].y))), rect->y0);
    t->x1 = lesser(last_center(greater(v[0].x, greater(v[1].x, v[2].x))), rect->x1 - 1);
    t->y1 = lesser(last_center(greater(v[0].y, greater(v[1].y, v[2].y))), rect->y1 - 1);
    return t->x0 <= t->x1 && t->y0 <= t->y1;
}

static double magnitude(double a)
{
    return a < 0 ? -a : a;
}

/* Depth in binary64: edge values are exact integers below 2^49, so the only errors are the
 * rounding of z_step and of three operations, far below half a step of D24. */
static void set_depth(GpTriangle *t, const GpRasterState *state)
{
    double z0 = (double)t->corner[0].z, area = (double)t->area2;
    t->z_step[0] = ((double)t->corner[1].z - z0) / area;
    t->z_step[1] = ((double)t->corner[2].z - z0) / area;

    double offset = (double)state->depth_bias;
    if (state->slope_depth_bias != 0) { /* skipped at 0: 0 * infinity is no number (R22) */
        double by_x = (double)t->a[1] * t->z_step[0] + (double)t->a[2] * t->z_step[1];
        double by_y = (double)t->b[1] * t->z_step[0] + (double)t->b[2] * t->z_step[1];
        by_x = magnitude(by_x) * GP_SUBPIXELS;
        by_y = magnitude(by_y) * GP_SUBPIXELS;
        offset += (by_x > by_y ? by_x : by_y) * (double)state->slope_depth_bias;
    }
    t->z_base = z0 + offset;
}

static void set_shading(GpTriangle *t)
{
    const GpScreenVertex *v = t->corner;
    const int nearer = v[1].rw > v[0].rw ? 1 : 0;
    t->inverse_area = 1.0f / (float)t->area2;
    t->nearest = v[2].rw > v[nearer].rw ? 2 : nearer;
    for (int i = 0; i < 2; i++)
        t->rw_ratio[i] = v[(t->nearest + 1 + i) % 3].rw / v[t->nearest].rw;
}

GpSetupResult gp_setup_triangle(const GpScreenVertex corner[3], const GpRasterState *state,
                                const GpRect *rect, GpTriangle *triangle)
{
    int64_t area2 = gp_signed_area2(corner);
    if (area2 == 0)
        return GP_SETUP_ZERO_AREA;
    bool front = area2 > 0;
    if (state->cull == (front ? GP_CULL_CW : GP_CULL_CCW))
        return GP_SETUP_CULLED;

    triangle->front = front;
    triangle->area2 = front ? area2 : -area2;
    triangle->corner[0] = corner[0];
    triangle->corner[1] = corner[front ? 1 : 2];
    triangle->corner[2] = corner[front ? 2 : 1];
    if (!set_box(triangle, rect))
        return GP_SETUP_OUTSIDE;

    set_edges(triangle);
    set_depth(triangle, state);
    set_shading(triangle);
    return GP_SETUP_DRAWN;
}

GpSetupResult gp_setup_point(const GpScreenVertex *center, float size, const GpRect *rect,
                             GpPointSprite *sprite)
{
    if (!(size > 0))
        return GP_SETUP_ZERO_AREA;
    float side = size < (float)GP_MAX_POINT_SIZE ? size : (float)GP_MAX_POINT_SIZE;
    int32_t whole = gp_snap(side), half = whole / 2;
    sprite->center = *center;
    sprite->left = center->x - half;
    sprite->top = center->y - half;
    sprite->right = sprite->left + whole;
    sprite->bottom = sprite->top + whole;
    if (whole == 0)
        return GP_SETUP_ZERO_AREA;

    /* top-left rule: a centre on the right or bottom side is outside */
    sprite->x0 = greater(first_center(sprite->left), rect->x0);
    sprite->y0 = greater(first_center(sprite->top), rect->y0);
    sprite->x1 = lesser(first_center(sprite->right) - 1, rect->x1 - 1);
    sprite->y1 = lesser(first_center(sprite->bottom) - 1, rect->y1 - 1);
    return sprite->x0 <= sprite->x1 && sprite->y0 <= sprite->y1 ? GP_SETUP_DRAWN : GP_SETUP_OUTSIDE;
}
