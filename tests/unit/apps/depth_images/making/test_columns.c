/* Columns of a cylinder's image, against half planes that are cut with triangles one by one. */
#include "apps/depth_images/making/columns.h"

#include "apps/base/vector.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#define TURN 6.28318530717958647692

enum { COLUMNS = 96, TRIANGLES = 400, ROUNDS = 12 };

/* A triangle as the axis sees it: along azimuth 0, and a quarter of a turn on. */
typedef struct Flat {
    double corner[3][2];
} Flat;

static DepthCylinder random_cylinder(Random *random)
{
    DepthCylinder cylinder = { .radius = random_between(random, 2, 6), .height = 4 };
    for (int k = 0; k < 3; k++) {
        cylinder.center[k] = random_between(random, -5, 5);
        cylinder.axis[k] = random_between(random, -1, 1);
        cylinder.zero[k] = random_between(random, -1, 1);
    }
    vector_normalize(cylinder.axis);
    vector_add_scaled(cylinder.zero, -vector_dot(cylinder.zero, cylinder.axis), cylinder.axis,
                      cylinder.zero);
    vector_normalize(cylinder.zero);
    return cylinder;
}

/* Of every size, anywhere in the cylinder; some around the axis, some along it, some a line or a
 * point. */
static void random_triangle(Random *random, const DepthCylinder *cylinder, float corner[9])
{
    const double size = random_int(random, 0, 3) ? 0.3 : 3;
    double middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] = random_between(random, -1, 1) * cylinder->radius * 0.6;
    const int kind = random_int(random, 0, 19);
    if (kind < 2)
        vector_set(middle, 0, 0, 0);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            corner[3 * i + k] =
                (float)(cylinder->center[k] + middle[k] + random_between(random, -size, size));
    if (kind == 3)
        memcpy(corner + 6, corner + 3, 3 * sizeof *corner);
    if (kind == 4)
        for (int k = 0; k < 3; k++)
            corner[6 + k] = (float)((double)corner[k] + 2 * cylinder->axis[k]);
}

static Flat seen_along_axis(const DepthCylinder *cylinder, const float corner[9])
{
    Flat flat;
    double aside[3];
    vector_cross(cylinder->axis, cylinder->zero, aside);
    for (int i = 0; i < 3; i++) {
        double off[3];
        for (int k = 0; k < 3; k++)
            off[k] = (double)corner[3 * i + k] - cylinder->center[k];
        flat.corner[i][0] = vector_dot(off, cylinder->zero);
        flat.corner[i][1] = vector_dot(off, aside);
    }
    return flat;
}

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* Whether the half plane in the middle of a column cuts an edge: from the axis on, in its
 * direction. */
static bool is_met(const Flat *flat, int column)
{
    const double turn = TURN * (column + 0.5) / COLUMNS, way[2] = { cos(turn), sin(turn) };
    for (int i = 0; i < 3; i++) {
        const double *a = flat->corner[i], *b = flat->corner[(i + 1) % 3];
        const double from = cross(way, a), to = cross(way, b);
        if ((from < 0) == (to < 0))
            continue;
        const double t = from / (from - to);
        if (way[0] * (a[0] + t * (b[0] - a[0])) + way[1] * (a[1] + t * (b[1] - a[1])) >= 0)
            return true;
    }
    return false;
}

static bool is_in(ColumnRange range, int column)
{
    return ((uint32_t)column + COLUMNS - range.first) % COLUMNS < range.count;
}

static double length_of(double x, double y)
{
    return sqrt(x * x + y * y);
}

/* From the axis to the triangle: to a corner, or to an edge before which it lies. HUGE_VAL: the
 * axis goes through it. */
static double nearest_of(const Flat *flat)
{
    double nearest = HUGE_VAL;
    int left = 0;
    for (int i = 0; i < 3; i++) {
        const double *a = flat->corner[i], *b = flat->corner[(i + 1) % 3];
        const double way[2] = { b[0] - a[0], b[1] - a[1] };
        const bool before = a[0] * way[0] + a[1] * way[1] < 0 && b[0] * way[0] + b[1] * way[1] > 0;
        left += cross(a, b) > 0;
        nearest = fmin(nearest, length_of(a[0], a[1]));
        if (before)
            nearest = fmin(nearest, fabs(cross(a, b)) / length_of(way[0], way[1]));
    }
    return left % 3 == 0 ? HUGE_VAL : nearest;
}

/* Columns that meet the triangle, or would if its corners were rounded some other way. */
static void check_all_are_told(Random *random, const Flat *flat, double rounding, ColumnRange range)
{
    Flat moved = *flat;
    for (int turn = 0; turn < 4; turn++) {
        for (int column = 0; column < COLUMNS; column++)
            assert_true(!is_met(&moved, column) || is_in(range, column));
        for (int i = 0; i < 6; i++)
            moved.corner[i / 2][i % 2] =
                flat->corner[i / 2][i % 2] + random_between(random, -rounding, rounding);
    }
}

/* What corners move by on each side, and one where columns begin in between. */
static void check_few_are_told(const Flat *flat, double radius, ColumnRange range)
{
    const double near = nearest_of(flat);
    uint32_t met = 0;
    for (int column = 0; column < COLUMNS; column++)
        met += is_met(flat, column);
    if (near < radius && near * 2 > TURN * radius / COLUMNS / 256)
        assert_true(range.count <= met + 2 * (1 + radius / near / 128) + 2);
}

static void ranges_have_what_half_planes_meet_and_little_more(void **state)
{
    (void)state;
    Random random = { 1 };
    int all = 0;
    for (int round = 0; round < ROUNDS; round++) {
        static float positions[9 * TRIANGLES];
        static uint32_t indices[3 * TRIANGLES];
        const DepthCylinder cylinder = random_cylinder(&random);
        const double rounding = TURN * cylinder.radius / COLUMNS / 512 / 1.42;
        GpMesh mesh = { .positions = positions,
                        .indices = indices,
                        .vertex_count = 3 * TRIANGLES,
                        .triangle_count = TRIANGLES };
        ColumnRange *ranges;
        for (uint32_t i = 0; i < 3 * TRIANGLES; i++)
            indices[i] = i;
        for (int i = 0; i < TRIANGLES; i++)
            random_triangle(&random, &cylinder, positions + 9 * i);
        assert_int_equal(columns_of(&cylinder, &mesh, COLUMNS, &ranges), GP_OK);
        for (int i = 0; i < TRIANGLES; i++) {
            const Flat flat = seen_along_axis(&cylinder, positions + 9 * i);
            assert_in_range(ranges[i].first, 0, COLUMNS - 1);
            assert_in_range(ranges[i].count, 1, COLUMNS);
            check_all_are_told(&random, &flat, rounding, ranges[i]);
            check_few_are_told(&flat, cylinder.radius, ranges[i]);
            all += ranges[i].count == COLUMNS;
        }
        gp_free(ranges);
    }
    assert_true(all > ROUNDS && all < ROUNDS * TRIANGLES / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranges_have_what_half_planes_meet_and_little_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
