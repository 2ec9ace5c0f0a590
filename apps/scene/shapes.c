#include "apps/scene/shapes.h"

#include "apps/base/camera.h"
#include "apps/scene/teapot.h"

#include <math.h>
#include <string.h>

/* --- the surfaces ----------------------------------------------------------------------------- */

/* Direction of a column on a circle about +y, to the right seen from outside. */
static void column_direction(const ShapePatch *patch, uint32_t column, double *x, double *z)
{
    double sine;
    angle_sincos(360.0 * column / patch->columns, &sine, x);
    *z = -sine;
}

static void sphere(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point)
{
    double x, z, radius, y;
    column_direction(patch, column, &x, &z);
    angle_sincos(180.0 * row / patch->rows, &radius, &y);
    vector_set(point->position, radius * x, y, radius * z);
    vector_set(point->normal, radius * x, y, radius * z);
}

static void torus(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point)
{
    const double major = 0.7, minor = 0.3;
    double x, z, up, out;
    column_direction(patch, column, &x, &z);
    angle_sincos(-360.0 * row / patch->rows, &up, &out);
    double radius = major + minor * out;
    vector_set(point->position, radius * x, minor * up, radius * z);
    vector_set(point->normal, out * x, up, out * z);
}

/* A tube round the (2, 3) torus knot. Any frame square to the curve gives the tube's exact normals;
 * this one is made of the first and second derivative, which are never parallel here. */
static void knot(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point)
{
    const double tube = 0.16, scale = 0.28;
    double s2, c2, s3, c3, sine, cosine, aside[3], out[3];
    double turn = (double)column / patch->columns;
    angle_sincos(720.0 * turn, &s2, &c2);
    angle_sincos(1080.0 * turn, &s3, &c3);
    angle_sincos(360.0 * row / patch->rows, &sine, &cosine);
    double centre[3] = { (2 + c3) * c2, s3, (2 + c3) * s2 };
    double first[3] = { -3 * s3 * c2 - 2 * (2 + c3) * s2, 3 * c3,
                        -3 * s3 * s2 + 2 * (2 + c3) * c2 };
    double second[3] = { -9 * c3 * c2 + 12 * s3 * s2 - 4 * (2 + c3) * c2, -9 * s3,
                         -9 * c3 * s2 - 12 * s3 * c2 - 4 * (2 + c3) * s2 };
    vector_cross(first, second, aside);
    vector_cross(aside, first, out);
    vector_normalize(aside);
    vector_normalize(out);
    for (int i = 0; i < 3; i++) {
        point->normal[i] = cosine * out[i] + sine * aside[i];
        point->position[i] = scale * centre[i] + tube * point->normal[i];
    }
}

/* data: radius and height at row 0, then at the last row: a cylinder, a cone or a disc. */
static void frustum(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point)
{
    const double *d = patch->data;
    double x, z, t = (double)row / patch->rows;
    column_direction(patch, column, &x, &z);
    double radius = d[0] + (d[2] - d[0]) * t;
    vector_set(point->position, radius * x, d[1] + (d[3] - d[1]) * t, radius * z);
    vector_set(point->normal, (d[1] - d[3]) * x, d[2] - d[0], (d[1] - d[3]) * z);
    if (d[1] == d[3]) { /* a disc: the picture lies on it flat */
        point->texcoord[0] = 0.5 + 0.5 * radius * x;
        point->texcoord[1] = 0.5 + 0.5 * radius * z;
    }
}

/* data: centre, step to the right edge, step to the bottom edge. */
static void rectangle(const ShapePatch *patch, uint32_t column, uint32_t row, ShapePoint *point)
{
    const double *d = patch->data;
    double u = 2.0 * column / patch->columns - 1.0, v = 2.0 * row / patch->rows - 1.0;
    for (int i = 0; i < 3; i++)
        point->position[i] = d[i] + u * d[3 + i] + v * d[6 + i];
    vector_cross(d + 6, d + 3, point->normal);
}

/* --- names ------------------------------------------------------------------------------------ */

static const double top_disc[] = { 0, 1, 1, 1 }, bottom_disc[] = { 1, -1, 0, -1 };
static const double tube_side[] = { 1, 1, 1, -1 }, cone_side[] = { 0, 1, 1, -1 };
static const double flat_disc[] = { 0, 0, 1, 0 };
static const double flat_plane[] = { 0, 0, 0, 1, 0, 0, 0, 0, 1 };
static const double upright_quad[] = { 0, 0, 0, 1, 0, 0, 0, -1, 0 };
static const double cube_sides[6][9] = {
    { 0, 0, 1, 1, 0, 0, 0, -1, 0 },  { 0, 0, -1, -1, 0, 0, 0, -1, 0 },
    { 1, 0, 0, 0, 0, -1, 0, -1, 0 }, { -1, 0, 0, 0, 0, 1, 0, -1, 0 },
    { 0, 1, 0, 1, 0, 0, 0, 0, 1 },   { 0, -1, 0, 1, 0, 0, 0, 0, -1 },
};

/* clang-format off */
static const struct { const char *name; int count; ShapePatch patches[6]; } table[] = {
    { "sphere",   1, { { sphere, 64, 32, true, false, NULL } } },
    { "ball",     1, { { sphere, 16, 8, true, false, NULL } } },
    { "torus",    1, { { torus, 96, 48, true, true, NULL } } },
    { "knot",     1, { { knot, 256, 24, true, true, NULL } } },
    { "cylinder", 3, { { frustum, 64, 1, true, false, tube_side },
                       { frustum, 64, 1, true, false, top_disc },
                       { frustum, 64, 1, true, false, bottom_disc } } },
    { "cone",     2, { { frustum, 64, 16, true, false, cone_side },
                       { frustum, 64, 1, true, false, bottom_disc } } },
    { "plane",    1, { { rectangle, 1, 1, false, false, flat_plane } } },
    { "disc",     1, { { frustum, 64, 1, true, false, flat_disc } } },
    { "quad",     1, { { rectangle, 1, 1, false, false, upright_quad } } },
    { "cube",     6, { { rectangle, 1, 1, false, false, cube_sides[0] },
                       { rectangle, 1, 1, false, false, cube_sides[1] },
                       { rectangle, 1, 1, false, false, cube_sides[2] },
                       { rectangle, 1, 1, false, false, cube_sides[3] },
                       { rectangle, 1, 1, false, false, cube_sides[4] },
                       { rectangle, 1, 1, false, false, cube_sides[5] } } },
};
/* clang-format on */

static const char *const points_names[] = { "sphere", "grid" };

const char *shape_name(size_t i)
{
    if (i < GP_COUNT(table))
        return table[i].name;
    return i == GP_COUNT(table) ? "teapot" : NULL;
}

const char *shape_points_name(size_t i)
{
    return i < GP_COUNT(points_names) ? points_names[i] : NULL;
}

GpResult shape_create(const char *name, Shape *shape)
{
    for (size_t i = 0; i < GP_COUNT(table); i++)
        if (strcmp(name, table[i].name) == 0)
            return shape_from_patches(table[i].patches, table[i].count, shape);
    return strcmp(name, "teapot") == 0 ? teapot_create(shape) : GP_ERROR_INVALID;
}

/* Point i of n on a sphere: equal areas, turned by the golden angle from one to the next. */
static void spiral_point(uint32_t i, uint32_t n, ShapePoint *point)
{
    double x, z, y = 1.0 - (2.0 * i + 1.0) / n, radius = sqrt(1.0 - y * y);
    angle_sincos(137.50776405003785 * i, &z, &x);
    vector_set(point->position, radius * x, y, radius * z);
    vector_set(point->normal, radius * x, y, radius * z);
}

static void grid_point(uint32_t i, uint32_t n, ShapePoint *point)
{
    uint32_t side = (uint32_t)sqrt((double)n);
    double u = (i % side + 0.5) / side, v = (i / side + 0.5) / side;
    vector_set(point->position, 2 * u - 1, 0, 2 * v - 1);
    vector_set(point->normal, 0, 1, 0);
    point->texcoord[0] = u;
    point->texcoord[1] = v;
}

GpResult shape_create_points(const char *name, Shape *shape)
{
    bool is_grid = strcmp(name, points_names[1]) == 0;
    uint32_t count = is_grid ? 64 * 64 : 5000;
    if (!is_grid && strcmp(name, points_names[0]) != 0)
        return GP_ERROR_INVALID;
    GpResult result = shape_alloc(shape, count, 0);
    for (uint32_t i = 0; i < count && !result; i++) {
        ShapePoint point = { 0 };
        (is_grid ? grid_point : spiral_point)(i, count, &point);
        shape_set_vertex(shape, i, &point);
    }
    return result;
}
