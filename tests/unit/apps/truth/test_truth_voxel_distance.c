/* Distances between volumes and models against what can be counted by hand, or looked for
 * everywhere. */
#include "apps/scene/shapes.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"
#include "apps/truth/voxel_distance.h"
#include "apps/truth/voxel_nearest.h"

enum { SIZE = 16 };

static const VoxelBox same = { .size = SIZE, .scale = 1 };
static uint8_t bits[SIZE * SIZE * SIZE / 8];

static void set(uint8_t *volume, uint32_t size, size_t x, size_t y, size_t z, bool value)
{
    size_t i = x + size * (y + size * z);
    volume[i / 8] = (uint8_t)((volume[i / 8] & ~(1u << i % 8)) | (unsigned)value << i % 8);
}

/* The same by any number of threads, and never below what is the least. */
static VoxelApart find(const VoxelDistance *distance, const VoxelBox *space, const uint8_t *volume)
{
    VoxelApart apart[2];
    const int threads[2] = { 1, 3 };
    for (int i = 0; i < 2; i++) {
        GpPool *pool;
        assert_int_equal(gp_pool_create(threads[i], &pool, NULL), GP_OK);
        double least;
        assert_int_equal(voxel_distance_find(distance, space, volume, pool, &apart[i]), GP_OK);
        assert_int_equal(voxel_distance_least(distance, space, pool, &least), GP_OK);
        assert_true(least <= apart[i].to_voxels);
        gp_pool_destroy(&pool);
    }
    assert_memory_equal(&apart[0], &apart[1], sizeof apart[0]);
    return apart[0];
}

static void expect_near(double value, double expected, double share)
{
    if (!(fabs(value - expected) <= share * expected))
        fail_msg("%g is not %g", value, expected);
}

/* --- a square --------------------------------------------------------------------------------- */

/* From 2 to 14 along x and y, at z = 5.25, and the 144 voxels that it is in. */
enum { SIDE = 12, VOXELS = SIDE * SIDE };
static const double a_side = SIDE;

static void make_square(VoxelDistance *distance)
{
    static const TruthTriangle square[2] = {
        { { { 2, 2, 5.25 }, { 14, 2, 5.25 }, { 14, 14, 5.25 } } },
        { { { 2, 2, 5.25 }, { 14, 14, 5.25 }, { 2, 14, 5.25 } } },
    };
    assert_int_equal(voxel_distance_make(square, 2, distance), GP_OK);
    assert_true(distance->longest == a_side);
    memset(bits, 0, sizeof bits);
    for (size_t y = 2; y < 14; y++)
        for (size_t x = 2; x < 14; x++)
            set(bits, SIZE, x, y, 5, true);
}

static void a_square_is_a_quarter_below_its_voxels(void **state)
{
    (void)state;
    VoxelDistance distance;
    make_square(&distance);
    VoxelApart apart = find(&distance, &same, bits);
    expect_near(apart.to_model, 0.25 / a_side, 1e-12);
    expect_near(apart.to_voxels, sqrt(1 / 12.0 + 1 / 12.0 + 1 / 16.0) / a_side, 1e-3);
    voxel_distance_free(&distance);
}

/* Its points go to one of four neighbours: squares of 1/2 in the mean in the plane instead of
 * 1/6. */
static void a_lost_voxel_is_a_hole_in_the_square(void **state)
{
    (void)state;
    VoxelDistance distance;
    make_square(&distance);
    double before = find(&distance, &same, bits).to_voxels;
    set(bits, SIZE, 7, 8, 5, false);
    VoxelApart apart = find(&distance, &same, bits);
    double rise = (apart.to_voxels * apart.to_voxels - before * before) * a_side * a_side;
    expect_near(rise, (1 / 2.0 - 1 / 6.0) / VOXELS, 0.05);
    expect_near(apart.to_model, 0.25 / a_side, 1e-12);
    voxel_distance_free(&distance);
}

static void a_strange_voxel_is_as_far_as_it_is(void **state)
{
    (void)state;
    VoxelDistance distance;
    make_square(&distance);
    double before = find(&distance, &same, bits).to_voxels;
    set(bits, SIZE, 8, 8, 14, true); /* 9.25 above the square */
    set(bits, SIZE, 0, 15, 5, true); /* beside its corner: 1.5, 1.5 and 1/4 */
    VoxelApart apart = find(&distance, &same, bits);
    double squares = VOXELS / 16.0 + 9.25 * 9.25 + (2.25 + 2.25 + 0.0625);
    expect_near(apart.to_model, sqrt(squares / (VOXELS + 2)) / a_side, 1e-12);
    assert_true(apart.to_voxels == before);
    voxel_distance_free(&distance);
}

static void nothing_is_a_whole_side_away(void **state)
{
    (void)state;
    VoxelDistance distance;
    make_square(&distance);
    memset(bits, 0, sizeof bits);
    VoxelApart apart = find(&distance, &same, bits);
    expect_near(apart.to_voxels, 1, 1e-12);
    assert_true(apart.to_model == 0);
    set(bits, SIZE, 0, 0, 15, true); /* 18 from the far corner, which counts as 12 */
    apart = find(&distance, &same, bits);
    assert_true(apart.to_voxels > 0.85 && apart.to_voxels < 1);
    voxel_distance_free(&distance);
}

/* Half of the square lies beside the volume, and is not asked for. */
static void what_is_cut_off_is_not_lost(void **state)
{
    (void)state;
    const VoxelBox moved = { .size = SIZE, .scale = 1, .offset = { 8, 0, 0 } };
    VoxelDistance distance;
    make_square(&distance);
    memset(bits, 0, sizeof bits);
    for (size_t y = 2; y < 14; y++)
        for (size_t x = 10; x < 16; x++)
            set(bits, SIZE, x, y, 5, true);
    VoxelApart apart = find(&distance, &moved, bits);
    expect_near(apart.to_model, 0.25 / a_side, 1e-12);
    expect_near(apart.to_voxels, sqrt(1 / 12.0 + 1 / 12.0 + 1 / 16.0) / a_side, 2e-3);
    voxel_distance_free(&distance);
}

/* --- shapes ----------------------------------------------------------------------------------- */

static TruthTriangle *make_shape(const char *name, VoxelBox *space, uint32_t *count)
{
    Shape shape;
    assert_int_equal(shape_create(name, &shape), GP_OK);
    float *positions = gp_alloc(shape.vertex_count, 3 * sizeof *positions);
    for (uint32_t i = 0; i < shape.vertex_count; i++)
        memcpy(positions + 3 * (size_t)i, shape.positions + 3 * i, 3 * sizeof *positions);
    *count = shape.index_count / 3;
    *space = voxel_box(positions, shape.indices, 3 * *count, space->size);
    TruthTriangle *triangles = gp_alloc(*count, sizeof *triangles);
    voxel_triangles(positions, shape.indices, *count, &(VoxelBox){ .scale = 1 }, triangles);
    gp_free(positions);
    shape_free(&shape);
    return triangles;
}

static uint8_t *touched_voxels(const TruthTriangle *triangles, uint32_t count,
                               const VoxelBox *space)
{
    uint8_t *volume = gp_alloc(voxel_bytes(space->size), 1);
    TruthTriangle *moved = gp_alloc(count, sizeof *moved);
    for (uint32_t i = 0; i < 9 * count; i++)
        moved[i / 9].corner[i / 3 % 3][i % 3] =
            space->scale * triangles[i / 9].corner[i / 3 % 3][i % 3] + space->offset[i % 3];
    voxel_surface(moved, count, space->size, 0, volume);
    gp_free(moved);
    return volume;
}

/* The least is what a full volume has, to the bit, wherever the model lies. */
static void nothing_is_nearer_than_a_full_volume(void **state)
{
    (void)state;
    static const double places[][4] = { { 1, 0, 0, 0 }, { 0.7, 5, -3, 2.125 }, { 3, -20, 1, 0.1 } };
    VoxelDistance distance;
    GpPool *pool;
    make_square(&distance);
    memset(bits, 0xff, sizeof bits);
    assert_int_equal(gp_pool_create(2, &pool, NULL), GP_OK);
    for (size_t i = 0; i < GP_COUNT(places); i++) {
        const double *place = places[i];
        const VoxelBox space = { .size = SIZE,
                                 .scale = place[0],
                                 .offset = { place[1], place[2], place[3] } };
        double least;
        assert_int_equal(voxel_distance_least(&distance, &space, pool, &least), GP_OK);
        assert_true(least > 0 && least == find(&distance, &space, bits).to_voxels);
    }
    gp_pool_destroy(&pool);
    voxel_distance_free(&distance);
}

/* A point's nearest centre is that of its own voxel, whatever the model and the size. */
static void touched_voxels_are_half_a_voxel_away(void **state)
{
    (void)state;
    static const char *const names[] = { "sphere", "torus", "knot", "teapot" };
    for (size_t i = 0; i < GP_COUNT(names); i++)
        for (uint32_t size = 23; size <= 64; size += 41) {
            VoxelBox space = { .size = size };
            VoxelDistance distance;
            uint32_t count;
            TruthTriangle *triangles = make_shape(names[i], &space, &count);
            uint8_t *volume = touched_voxels(triangles, count, &space);
            assert_int_equal(voxel_distance_make(triangles, count, &distance), GP_OK);
            VoxelApart apart = find(&distance, &space, volume);
            expect_near(apart.to_voxels * (size - 2.5), 0.5, 0.05);
            assert_true(apart.to_model < apart.to_voxels);
            voxel_distance_free(&distance);
            gp_free(volume);
            gp_free(triangles);
        }
}

/* How far centres are from a sphere needs no triangles. */
static void centres_are_as_far_from_a_sphere_as_their_radius_says(void **state)
{
    (void)state;
    VoxelBox space = { .size = 24 };
    VoxelDistance distance;
    uint32_t count;
    TruthTriangle *triangles = make_shape("sphere", &space, &count);
    uint8_t *volume = touched_voxels(triangles, count, &space);
    assert_int_equal(voxel_distance_make(triangles, count, &distance), GP_OK);
    set(volume, 24, 12, 12, 12, true);
    double sum = 0;
    for (size_t i = 0; (i = voxel_next(volume, 24, i)) < (size_t)24 * 24 * 24; i++) {
        uint32_t at[3];
        double square = 0;
        voxel_place(i, 24, at);
        for (int k = 0; k < 3; k++)
            square += (at[k] + 0.5 - 12) * (at[k] + 0.5 - 12);
        sum += (sqrt(square) - 10.75) * (sqrt(square) - 10.75);
    }
    double expected = sqrt(sum / (double)voxel_count(volume, 24)) / 21.5;
    expect_near(find(&distance, &space, volume).to_model, expected, 0.005);
    voxel_distance_free(&distance);
    gp_free(volume);
    gp_free(triangles);
}

/* --- the nearest voxel ------------------------------------------------------------------------ */

static double plain_nearest(const uint8_t *volume, uint32_t size, const double point[3],
                            double most)
{
    double nearest = most;
    for (size_t i = 0; i < (size_t)size * size * size; i++) {
        uint32_t at[3];
        double off[3];
        voxel_place(i, size, at);
        for (int k = 0; k < 3; k++)
            off[k] = at[k] + 0.5 - point[k];
        if (volume[i / 8] >> i % 8 & 1)
            nearest = fmin(nearest, sqrt(vector_dot(off, off)));
    }
    return nearest;
}

static void the_pyramid_finds_the_nearest_of_all(void **state)
{
    (void)state;
    static const uint32_t sizes[] = { 1, 2, 5, 8, 13, 16 };
    Random random = { 5 };
    for (int round = 0; round < 240; round++) {
        const uint32_t size = sizes[(size_t)round % GP_COUNT(sizes)];
        memset(bits, 0, sizeof bits);
        for (int i = 0; i < round / 6; i++) {
            size_t at[3];
            for (int k = 0; k < 3; k++)
                at[k] = (size_t)random_int(&random, 0, (int)size - 1);
            set(bits, size, at[0], at[1], at[2], true);
        }
        VoxelPyramid pyramid;
        assert_int_equal(voxel_pyramid_make(bits, size, &pyramid), GP_OK);
        for (int i = 0; i < 20; i++) {
            double point[3], most = i % 2 ? 100 : 3;
            for (int k = 0; k < 3; k++)
                point[k] = (double)random_float(&random, -2, (float)size + 2);
            assert_true(fabs(voxel_pyramid_nearest(&pyramid, point, most) -
                             plain_nearest(bits, size, point, most)) < 1e-12);
        }
        voxel_pyramid_free(&pyramid);
    }
}

static void the_next_voxel_is_the_next_bit(void **state)
{
    (void)state;
    static const size_t places[] = { 0, 7, 8, 63, 100, 124 };
    enum { FIVE = 5, ALL = FIVE * FIVE * FIVE };
    memset(bits, 0, sizeof bits);
    assert_int_equal(voxel_next(bits, FIVE, 0), ALL);
    for (size_t i = 0; i < GP_COUNT(places); i++)
        set(bits, FIVE, places[i] % FIVE, places[i] / FIVE % FIVE, places[i] / FIVE / FIVE, true);
    size_t found = 0;
    for (size_t i = 0; (i = voxel_next(bits, FIVE, i)) < ALL; i++)
        assert_true(found < GP_COUNT(places) && i == places[found++]);
    assert_int_equal(found, GP_COUNT(places));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_square_is_a_quarter_below_its_voxels),
        cmocka_unit_test(a_lost_voxel_is_a_hole_in_the_square),
        cmocka_unit_test(a_strange_voxel_is_as_far_as_it_is),
        cmocka_unit_test(nothing_is_a_whole_side_away),
        cmocka_unit_test(what_is_cut_off_is_not_lost),
        cmocka_unit_test(nothing_is_nearer_than_a_full_volume),
        cmocka_unit_test(touched_voxels_are_half_a_voxel_away),
        cmocka_unit_test(centres_are_as_far_from_a_sphere_as_their_radius_says),
        cmocka_unit_test(the_pyramid_finds_the_nearest_of_all),
        cmocka_unit_test(the_next_voxel_is_the_next_bit),
    };
    return cmocka_run_group_tests_name("distance of voxels", tests, NULL, NULL);
}
