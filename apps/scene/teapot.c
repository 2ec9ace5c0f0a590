/* The Utah teapot: Martin Newell's 32 bicubic Bezier patches (1975), with the lid knob and bottom
 * that Blinn and others published since.
 *
 * Twenty-four patches are six profile curves turned about the axis in four quarters: their control
 * points are those of a profile times those of a quarter circle (1, 0) (1, k) (k, 1) (0, 1), k =
 * 0.56 as Newell had it. So both are evaluated on their own, and the surface is their product; its
 * normal then has no radius in it and needs no special case at the poles. Handle and spout are two
 * patches along and one on either side of the plane of symmetry.
 * DEVIATES: Newell rounded k * 0.8 on the lid's knob to 0.45; here it is 0.448.
 */
#include "apps/scene/teapot.h"

#include "apps/base/vector.h"

enum { STEPS = 12 }; /* quads along a patch */

/* Value and derivative of a cubic Bezier curve; points lie `stride` doubles apart. */
static double bezier(const double *p, int stride, double t, double *derivative)
{
    double a = p[0], b = p[stride], c = p[2 * stride], d = p[3 * stride], s = 1.0 - t;
    *derivative = 3.0 * (s * s * (b - a) + 2.0 * s * t * (c - b) + t * t * (d - c));
    return s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
}

/* Splits a grid line over patches in a row into a patch and a parameter; the last line belongs to
 * the last patch. */
static uint32_t patch_of(uint32_t line, uint32_t lines, double *t)
{
    uint32_t patch = line < lines ? line / STEPS : line / STEPS - 1;
    *t = (double)(line - patch * STEPS) / STEPS;
    return patch;
}

/* data: profile of (radius, height), three points a patch and one more, downwards outside. */
static void revolve(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point)
{
    static const double quarter_x[4] = { 1, 1, 0.56, 0 }, quarter_y[4] = { 0, 0.56, 1, 1 };
    double t, dx, dy, dradius, dheight;
    uint32_t quarter = patch_of(column, 4 * STEPS, &t);
    double x = bezier(quarter_x, 1, t, &dx), y = bezier(quarter_y, 1, t, &dy);
    for (; quarter > 0; quarter--) { /* turn by 90 degrees, exactly */
        double old_x = x, old_dx = dx;
        x = -y;
        y = old_x;
        dx = -dy;
        dy = old_dx;
    }
    const double *profile = patch->data + 6 * patch_of(row, patch->rows, &t);
    double radius = bezier(profile, 2, t, &dradius);
    double height = bezier(profile + 1, 2, t, &dheight);
    vector_set(point->position, radius * x, height, -radius * y);
    vector_set(point->normal, -dheight * dy, dradius * (x * dy - y * dx), -dheight * dx);
}

/* data: rows of control points (x, height) of one edge, (x, height) of the other, half width; the
 * cross section is a cubic from edge to edge on each side of z = 0. */
static void sweep(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point)
{
    double u, v, section[3][4], along[3][4], by_u[3], by_v[3];
    uint32_t side = patch_of(column, patch->columns, &u);
    const double *rows = patch->data + 15 * patch_of(row, patch->rows, &v);
    if (side == 1) /* back on the other side */
        u = 1.0 - u;
    for (int i = 0; i < 4; i++) {
        int edge = i < 2 ? 0 : 2;
        section[0][i] = bezier(rows + edge, 5, v, &along[0][i]);
        section[1][i] = bezier(rows + edge + 1, 5, v, &along[1][i]);
        section[2][i] = bezier(rows + 4, 5, v, &along[2][i]);
        double sign = i % 3 == 0 ? 0.0 : side == 0 ? -1.0 : 1.0; /* both edges lie on z = 0 */
        section[2][i] *= sign;
        along[2][i] *= sign;
    }
    for (int i = 0; i < 3; i++) {
        double unused;
        point->position[i] = bezier(section[i], 1, u, &by_u[i]);
        by_v[i] = bezier(along[i], 1, u, &unused);
        if (side == 1)
            by_u[i] = -by_u[i];
    }
    vector_cross(by_v, by_u, point->normal);
}

/* clang-format off */
static const double body[] = {
    1.4, 2.4,   1.3375, 2.53125,   1.4375, 2.53125,
    1.5, 2.4,   1.75, 1.875,       2.0, 1.35,
    2.0, 0.9,   2.0, 0.45,         1.5, 0.225,
    1.5, 0.15,  1.5, 0.075,        1.425, 0.0,       0.0, 0.0,
};
static const double lid[] = {
    0.0, 3.15,  0.8, 3.15,         0.0, 2.85,
    0.2, 2.7,   0.4, 2.55,         1.3, 2.55,        1.3, 2.4,
};
static const double handle[] = {
    -1.6, 2.025,  -1.5, 2.25,    0.3,
    -2.3, 2.025,  -2.5, 2.25,    0.3,
    -2.7, 2.025,  -3.0, 2.25,    0.3,
    -2.7, 1.8,    -3.0, 1.8,     0.3,
    -2.7, 1.575,  -3.0, 1.35,    0.3,
    -2.5, 1.125,  -2.65, 0.9375, 0.3,
    -2.0, 0.9,    -1.9, 0.6,     0.3,
};
static const double spout[] = {
    1.7, 1.425,   1.7, 0.6,        0.66,
    2.6, 1.425,   3.1, 0.825,      0.66,
    2.3, 2.1,     2.4, 2.025,      0.25,
    2.7, 2.4,     3.3, 2.4,        0.25,
    2.8, 2.475,   3.525, 2.49375,  0.25,
    2.9, 2.475,   3.45, 2.5125,    0.15,
    2.8, 2.4,     3.2, 2.4,        0.15,
};
/* clang-format on */

static void revolve_control(const double *profile, uint32_t quarter, float control[4][4][3])
{
    static const double quarter_x[4] = { 1, 1, 0.56, 0 }, quarter_y[4] = { 0, 0.56, 1, 1 };
    static const double cosine[4] = { 1, 0, -1, 0 }, sine[4] = { 0, 1, 0, -1 };
    const double c = cosine[quarter], s = sine[quarter];
    for (int row = 0; row < 4; row++)
        for (int i = 0; i < 4; i++) {
            float *p = control[row][i];
            p[0] = (float)(profile[2 * row] * (c * quarter_x[i] - s * quarter_y[i]));
            p[1] = (float)profile[2 * row + 1];
            p[2] = (float)(-profile[2 * row] * (s * quarter_x[i] + c * quarter_y[i]));
        }
}

static void sweep_control(const double *rows, uint32_t side, float control[4][4][3])
{
    for (int row = 0; row < 4; row++)
        for (int i = 0; i < 4; i++) {
            const double *edge = rows + 5 * row + (i < 2 ? 0 : 2);
            float *p = control[row][i];
            p[0] = (float)edge[0];
            p[1] = (float)edge[1];
            p[2] = i % 3 == 0 ? 0.0f : (float)(side == 0 ? -rows[5 * row + 4] : rows[5 * row + 4]);
        }
}

void teapot_control(float control[TEAPOT_PATCHES][4][4][3])
{
    uint32_t n = 0;
    for (uint32_t quarter = 0; quarter < 4; quarter++) {
        for (int i = 0; i < 4; i++)
            revolve_control(body + 6 * i, quarter, control[n++]);
        for (int i = 0; i < 2; i++)
            revolve_control(lid + 6 * i, quarter, control[n++]);
    }
    for (uint32_t side = 0; side < 2; side++)
        for (int i = 0; i < 2; i++) {
            sweep_control(handle + 15 * i, side, control[n++]);
            sweep_control(spout + 15 * i, side, control[n++]);
        }
    GP_ASSERT(n == TEAPOT_PATCHES);
}

GpResult teapot_create(Shape *shape)
{
    static const ShapePatch patches[] = {
        { revolve, 4 * STEPS, 4 * STEPS, true, false, body },
        { revolve, 4 * STEPS, 2 * STEPS, true, false, lid },
        { sweep, 2 * STEPS, 2 * STEPS, true, false, handle },
        { sweep, 2 * STEPS, 2 * STEPS, true, false, spout },
    };
    return shape_from_patches(patches, (int)GP_COUNT(patches), shape);
}
