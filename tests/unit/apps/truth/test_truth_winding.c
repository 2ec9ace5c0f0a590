/* Winding numbers by crossings, held against the sum of the solid angles that triangles are seen
 * at.
 * source van Oosterom and Strackee, "The solid angle of a plane triangle", IEEE Transactions on
 *        Biomedical Engineering 30(2), 1983 */
#include "apps/scene/shapes.h"
#include "apps/truth/triangle.h"
#include "apps/truth/voxel_winding.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { SIZE = 14, VOXELS = SIZE * SIZE * SIZE, MOST = 20000 };

static TruthTriangle triangles[MOST];
static uint32_t triangle_count;

/* --- models ----------------------------------------------------------------------------------- */

/* Adds a shape of radius 1, scaled, moved, and turned over where the scale is negative. */
static void add_shape(const char *name, double scale, double x, double y, double z)
{
    Shape shape;
    const double offset[3] = { x, y, z };
    assert_int_equal(shape_create(name, &shape), GP_OK);
    assert_true(triangle_count + shape.index_count / 3 <= MOST);
    for (uint32_t i = 0; i < shape.index_count; i++)
        for (int k = 0; k < 3; k++)
            triangles[triangle_count + i / 3].corner[scale < 0 ? 2 - i % 3 : i % 3][k] =
                fabs(scale) * (double)shape.positions[3 * shape.indices[i] + (uint32_t)k] +
                offset[k];
    triangle_count += shape.index_count / 3;
    shape_free(&shape);
}

/* --- solid angles ----------------------------------------------------------------------------- */

/* Positive where a triangle is seen from its back, as from inside. */
static double solid_angle(const TruthTriangle *t, const double point[3])
{
    double r[3][3], length[3], cross[3];
    for (int i = 0; i < 3; i++) {
        vector_subtract(t->corner[i], point, r[i]);
        length[i] = sqrt(vector_dot(r[i], r[i]));
    }
    vector_cross(r[1], r[2], cross);
    const double below = length[0] * length[1] * length[2] + vector_dot(r[0], r[1]) * length[2] +
                         vector_dot(r[1], r[2]) * length[0] + vector_dot(r[2], r[0]) * length[1];
    return 2 * atan2(vector_dot(r[0], cross), below);
}

static double nearest(const double point[3])
{
    double square = HUGE_VAL;
    for (uint32_t i = 0; i < triangle_count; i++)
        square = fmin(square, truth_square_to_triangle(point, &triangles[i]));
    return sqrt(square);
}

static bool get(const uint8_t *bits, uint32_t i)
{
    return bits[i / 8] >> i % 8 & 1;
}

/* What is expected of all voxels that are not on the surface; counts by winding number -2 to 3. */
static void expect_angles(uint64_t found[6])
{
    static const double turn = 12.56637061435917295385;
    uint64_t doubled = 0, beside = 0;
    VoxelWinding along[3];
    memset(found, 0, 6 * sizeof *found);
    for (int axis = 0; axis < 3; axis++) {
        assert_int_equal(voxel_winding_make(triangles, triangle_count, SIZE, axis, &along[axis]),
                         GP_OK);
        assert_int_equal(along[axis].odd_columns, 0);
        assert_memory_equal(along[axis].odd, along[0].odd, voxel_bytes(SIZE));
        assert_memory_equal(along[axis].inside, along[0].inside, voxel_bytes(SIZE));
        assert_int_equal(along[axis].doubled, along[0].doubled);
    }
    for (uint32_t i = 0; i < VOXELS; i++) {
        const double centre[3] = { i % SIZE + 0.5, i / SIZE % SIZE + 0.5, i / SIZE / SIZE + 0.5 };
        double sum = 0;
        if (nearest(centre) < 1e-6) {
            beside++;
            continue;
        }
        for (uint32_t t = 0; t < triangle_count; t++)
            sum += solid_angle(&triangles[t], centre);
        const int number = (int)lround(sum / turn);
        assert_true(fabs(sum / turn - number) < 1e-9);
        assert_in_range(number + 2, 0, 5);
        assert_int_equal(get(along[0].inside, i), number != 0);
        assert_int_equal(get(along[0].odd, i), number % 2 != 0);
        doubled += number != 0 && number % 2 == 0;
        found[number + 2]++;
    }
    assert_true(along[0].doubled >= doubled && along[0].doubled <= doubled + beside);
    for (int axis = 0; axis < 3; axis++)
        voxel_winding_free(&along[axis]);
}

/* --- facts ------------------------------------------------------------------------------------ */

static void parts_that_overlap_or_are_nested_count_twice(void **state)
{
    (void)state;
    uint64_t found[6];
    triangle_count = 0;
    add_shape("ball", 4, 5.1, 6.2, 6.3);
    add_shape("ball", 3.7, 9.3, 7.1, 6.9);
    expect_angles(found);
    assert_true(found[1 + 2] > 200 && found[2 + 2] > 50 && found[0] + found[1] + found[5] == 0);
    add_shape("cube", 0.9, 7.3, 6.4, 6.6); /* in both */
    expect_angles(found);
    assert_true(found[3 + 2] >= 1);
    add_shape("ball", 1, 3.2, 5.9, 6.1); /* in one */
    expect_angles(found);
}

static void a_hollow_has_none_and_what_is_inside_out_has_fewer(void **state)
{
    (void)state;
    uint64_t found[6];
    triangle_count = 0;
    add_shape("ball", 6, 7, 7, 7);
    add_shape("ball", -3, 7.2, 7.1, 6.8); /* a hollow */
    expect_angles(found);
    assert_true(found[1 + 2] > 300 && found[2 + 2] == 0 && found[1] == 0);
    triangle_count = 0;
    add_shape("cube", -3.3, 6.2, 7.1, 7.4);
    add_shape("cube", -2.1, 9.6, 8.3, 6.2);
    expect_angles(found);
    assert_true(found[-1 + 2] > 100 && found[-2 + 2] > 10 && found[1 + 2] == 0);
}

/* Centres on sides and edges, lines through corners: alike along all axes, and each line is crossed
 * as often up as down. */
static void what_lies_on_the_surface_is_alike_along_all_axes(void **state)
{
    (void)state;
    uint64_t found[6];
    triangle_count = 0;
    add_shape("cube", 3, 6.5, 6.5, 6.5);
    add_shape("cube", 2, 9.5, 8.5, 6.5);
    expect_angles(found);
    assert_true(found[1 + 2] > 100 && found[2 + 2] > 5);
    triangle_count = 0;
    add_shape("sphere", 4, 6.5, 6.5, 6.5); /* its seam and poles on centres */
    expect_angles(found);
    assert_true(found[1 + 2] > 100);
}

/* Beyond the volume all is counted that lies above it, and nothing that lies beside it. */
static void parts_outside_the_volume_count_where_they_are_above(void **state)
{
    (void)state;
    uint64_t found[6];
    Random random = { 3 };
    for (int i = 0; i < 6; i++) {
        triangle_count = 0;
        for (int part = 0; part < 3; part++)
            add_shape(part ? "ball" : "cube", (double)random_float(&random, 2, 9),
                      (double)random_float(&random, -5, SIZE + 5),
                      (double)random_float(&random, -5, SIZE + 5),
                      (double)random_float(&random, -5, SIZE + 5));
        expect_angles(found);
    }
}

/* A wall across y alone: columns along y cross one triangle. */
static void an_open_wall_is_odd_along_its_normal(void **state)
{
    (void)state;
    VoxelWinding winding;
    triangle_count = 0;
    add_shape("plane", 4, 7, 7.2, 7); /* from 3 to 11: 8 lines a side */
    for (int axis = 0; axis < 3; axis++) {
        assert_int_equal(voxel_winding_make(triangles, triangle_count, SIZE, axis, &winding),
                         GP_OK);
        assert_int_equal(winding.odd_columns, axis == 1 ? 64 : 0);
        assert_int_equal(voxel_count(winding.odd, SIZE), axis == 1 ? 64 * 7 : 0);
        assert_int_equal(voxel_count(winding.inside, SIZE), axis == 1 ? 64 * 7 : 0);
        assert_int_equal(winding.doubled, 0);
        voxel_winding_free(&winding);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_that_overlap_or_are_nested_count_twice),
        cmocka_unit_test(a_hollow_has_none_and_what_is_inside_out_has_fewer),
        cmocka_unit_test(what_lies_on_the_surface_is_alike_along_all_axes),
        cmocka_unit_test(parts_outside_the_volume_count_where_they_are_above),
        cmocka_unit_test(an_open_wall_is_odd_along_its_normal),
    };
    return cmocka_run_group_tests_name("winding numbers", tests, NULL, NULL);
}
