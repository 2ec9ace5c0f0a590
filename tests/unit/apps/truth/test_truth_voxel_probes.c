/* Wrong volume against what can be counted by hand. */
#include "apps/scene/shapes.h"
#include "tests/support/unit.h"
#include "apps/truth/voxel_probes.h"

enum { SIZE = 16, PROBES = 2000000 /* as voxel_probes.c has them */ };

static const VoxelBox same = { .size = SIZE, .scale = 1 };
static uint8_t bits[SIZE * SIZE * SIZE / 8];

static void turn(size_t x, size_t y, size_t z)
{
    size_t i = x + SIZE * (y + SIZE * z);
    bits[i / 8] = (uint8_t)(bits[i / 8] ^ 1u << i % 8);
}

/* The same by any number of threads. */
static double wrong_of(const VoxelProbes *probes, const VoxelBox *space, const uint8_t *volume)
{
    double wrong[2];
    const int threads[2] = { 1, 3 };
    for (int i = 0; i < 2; i++) {
        GpPool *pool;
        assert_int_equal(gp_pool_create(threads[i], &pool, NULL), GP_OK);
        wrong[i] = voxel_probes_wrong(probes, space, volume, pool);
        gp_pool_destroy(&pool);
    }
    assert_true(wrong[0] == wrong[1]);
    return wrong[0];
}

static void expect_near(double value, double expected, double share)
{
    if (!(fabs(value - expected) <= share * expected))
        fail_msg("%g is not %g", value, expected);
}

/* The triangles of a shape, scaled and moved. The caller frees them. */
static TruthTriangle *make_shape(const char *name, const double scale[3], double offset,
                                 uint32_t *count)
{
    Shape shape;
    assert_int_equal(shape_create(name, &shape), GP_OK);
    *count = shape.index_count / 3;
    TruthTriangle *triangles = gp_alloc(*count, sizeof *triangles);
    for (uint32_t i = 0; i < 3 * *count; i++)
        for (int k = 0; k < 3; k++)
            triangles[i / 3].corner[i % 3][k] =
                scale[k] * (double)shape.positions[3 * shape.indices[i] + (uint32_t)k] + offset;
    shape_free(&shape);
    return triangles;
}

/* --- a box ------------------------------------------------------------------------------------ */

enum { VOXELS = 8 * 4 * 4 };

/* From (4, 6, 6) to (12, 10, 10), which is as many voxels, all set. builtin:cube is from -1 to
 * 1. */
static void make_box(VoxelProbes *probes)
{
    uint32_t count;
    TruthTriangle *triangles = make_shape("cube", (const double[]){ 4, 2, 2 }, 8, &count);
    assert_int_equal(voxel_probes_make(triangles, count, VOXEL_BY_PARITY, probes), GP_OK);
    gp_free(triangles);
    expect_near(probes->side, 9, 1e-12);
    memset(bits, 0, sizeof bits);
    for (size_t z = 6; z < 10; z++)
        for (size_t y = 6; y < 10; y++)
            for (size_t x = 4; x < 12; x++)
                turn(x, y, z);
}

static void a_box_of_voxels_has_nothing_wrong(void **state)
{
    (void)state;
    VoxelProbes probes;
    make_box(&probes);
    expect_near((double)probes.inside_count, PROBES * VOXELS / 729.0, 1e-3);
    assert_true(wrong_of(&probes, &same, bits) == 0);
    voxel_probes_free(&probes);
}

static void a_voxel_more_or_less_is_its_volume(void **state)
{
    (void)state;
    VoxelProbes probes;
    make_box(&probes);
    turn(7, 8, 9); /* lost */
    expect_near(wrong_of(&probes, &same, bits), 1.0 / VOXELS, 0.02);
    turn(7, 11, 9); /* and one outside */
    expect_near(wrong_of(&probes, &same, bits), 2.0 / VOXELS, 0.02);
    turn(12, 7, 7); /* beyond its end, seen as far as the cube of probes goes: by half */
    expect_near(wrong_of(&probes, &same, bits), 2.5 / VOXELS, 0.02);
    voxel_probes_free(&probes);
}

static void nothing_is_all_wrong_and_everything_is_worse(void **state)
{
    (void)state;
    VoxelProbes probes;
    make_box(&probes);
    memset(bits, 0, sizeof bits);
    assert_true(wrong_of(&probes, &same, bits) == 1);
    memset(bits, 0xff, sizeof bits);
    expect_near(wrong_of(&probes, &same, bits), (729.0 - VOXELS) / VOXELS, 1e-3);
    voxel_probes_free(&probes);
}

/* Half of it is outside the volume, and not asked for. */
static void what_is_cut_off_is_not_wrong(void **state)
{
    (void)state;
    const VoxelBox moved = { .size = SIZE, .scale = 1, .offset = { 8, 0, 0 } };
    VoxelProbes probes;
    make_box(&probes);
    memset(bits, 0, sizeof bits);
    expect_near(wrong_of(&probes, &moved, bits), 0.5, 3e-3);
    voxel_probes_free(&probes);
}

/* --- curved ----------------------------------------------------------------------------------- */

/* Share that is wrong of a shape whose voxels are those with their centres inside. */
static double wrong_at(const char *name, uint32_t size, VoxelProbes *probes)
{
    const double scale = (size - 2.5) / 2; /* of shapes within 1 */
    uint32_t count;
    TruthTriangle *triangles =
        make_shape(name, (const double[]){ scale, scale, scale }, size / 2.0, &count);
    uint8_t *volume = gp_alloc(voxel_bytes(size), 1);
    voxel_solid(triangles, count, size, volume);
    assert_int_equal(voxel_probes_make(triangles, count, VOXEL_BY_PARITY, probes), GP_OK);
    double wrong = wrong_of(probes, &(VoxelBox){ .size = size, .scale = 1 }, volume);
    gp_free(volume);
    gp_free(triangles);
    return wrong;
}

/* Where the surface crosses a voxel, what lies between it and the centre is wrong: |n . p| in the
 * mean over points p of a cube around 0, which is 0.25 voxels for normals n along an axis, and 0.23
 * for the most slanted. A ball has area times radius / 3 for its volume. */
static void a_ball_has_a_quarter_of_a_voxel_wrong(void **state)
{
    (void)state;
    for (uint32_t size = 32; size <= 96; size += 32) {
        VoxelProbes probes;
        const double radius = (size - 2.5) / 2, wrong = wrong_at("sphere", size, &probes);
        const double enclosed = 4 * 3.14159265358979 / 3 * radius * radius * radius;
        expect_near((double)probes.inside_count / PROBES * pow(probes.side, 3), enclosed,
                    0.006); /* of facets a little less */
        expect_near(wrong, 0.24 * 3 / radius, 0.05);
        voxel_probes_free(&probes);
    }
}

/* Twice as many voxels a side, half as much: of streaks there would be as much. */
static void finer_voxels_have_less_wrong(void **state)
{
    (void)state;
    VoxelProbes probes;
    static const char *const names[] = { "torus", "knot", "cylinder", "cone" };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        double coarse = wrong_at(names[i], 32, &probes);
        voxel_probes_free(&probes);
        double fine = wrong_at(names[i], 64, &probes);
        voxel_probes_free(&probes);
        expect_near(fine / coarse, 29.5 / 61.5, 0.1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_of_voxels_has_nothing_wrong),
        cmocka_unit_test(a_voxel_more_or_less_is_its_volume),
        cmocka_unit_test(nothing_is_all_wrong_and_everything_is_worse),
        cmocka_unit_test(what_is_cut_off_is_not_wrong),
        cmocka_unit_test(a_ball_has_a_quarter_of_a_voxel_wrong),
        cmocka_unit_test(finer_voxels_have_less_wrong),
    };
    return cmocka_run_group_tests_name("wrong volume", tests, NULL, NULL);
}
