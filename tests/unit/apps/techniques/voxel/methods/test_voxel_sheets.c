/* The printed method of voxelization, one bit a voxel: what it finds, what adding bits loses, and
 * what one direction loses. */
#include "apps/techniques/voxel/methods/sort.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

#include <math.h>

/* Positions are snapped to 256ths of a voxel, and a dominant axis has slopes of at most 1. */
#define MARGIN (1.0 / 128)

static const VoxelSetting printed = {
    .method = VOXEL_SHEETS, .size = 64, .bits = 1, .blend = VOXEL_ADD, .axes = 3
};

static VoxelSetting with_or(uint32_t size)
{
    VoxelSetting setting = printed;
    setting.size = size;
    setting.blend = VOXEL_OR;
    return setting;
}

/* --- samples ---------------------------------------------------------------------------------- */

/* Whether rounding may make another axis the dominant one. */
static bool is_tie(const TruthTriangle *t)
{
    double edge[2][3], normal[3], most = 0;
    vector_subtract(t->corner[1], t->corner[0], edge[0]);
    vector_subtract(t->corner[2], t->corner[0], edge[1]);
    vector_cross(edge[0], edge[1], normal);
    int near = 0;
    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(normal[k]));
    for (int k = 0; k < 3; k++)
        near += fabs(normal[k]) >= most * (1 - 1e-6);
    return near > 1;
}

/* Every sample that is met for certain is set, and none that is missed for certain. */
static void check_samples(const VoxelCase *given)
{
    const uint32_t size = given->size;
    const VoxelSetting setting = with_or(size);
    uint8_t *voxels = voxel_case_volume(given, &setting);
    uint8_t *in = gp_alloc(voxel_bytes(size), 1), *out = gp_alloc(voxel_bytes(size), 1);
    for (uint32_t i = 0; i < given->model.triangle_count; i++) {
        const TruthTriangle *t = &given->triangles[i];
        const bool tie = is_tie(t);
        if (!tie)
            voxel_thin(t, 1, size, 0, -MARGIN, in);
        voxel_thin(t, 1, size, tie ? VOXEL_ALL_AXES : 0, MARGIN, out);
    }
    assert_true(voxel_count(in, size) > 10);
    assert_int_equal(voxel_count_without(in, voxels, size), 0);
    assert_int_equal(voxel_count_without(voxels, out, size), 0);
    gp_free(voxels);
    gp_free(in);
    gp_free(out);
}

static void samples_are_those_of_the_dominant_axis(void **state)
{
    (void)state;
    static const struct {
        const char *shape;
        uint32_t size;
        double turn;
    } cases[] = { { "sphere", 32, 0 },  { "torus", 64, 0.7 }, { "knot", 45, 0 },
                  { "teapot", 100, 2 }, { "cube", 40, 0.3 },  { "teapot", 136, 0 } };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VoxelCase given = voxel_case_open(cases[i].shape, cases[i].turn, cases[i].size);
        check_samples(&given);
        voxel_case_free(&given);
    }
}

/* What leaves the volume is cut off, and does not come back elsewhere. */
static void what_lies_outside_is_not_there(void **state)
{
    (void)state;
    enum { SIZE = 40, COUNT = 60 };
    Random random = { 3 };
    float corners[9 * COUNT];
    for (size_t i = 0; i < GP_COUNT(corners); i++)
        corners[i] = random_float(&random, -60, 100);
    VoxelCase given = voxel_case_of(corners, COUNT, SIZE);
    check_samples(&given);
    voxel_case_free(&given);
}

/* --- lists ------------------------------------------------------------------------------------ */

/* Each triangle is in one list, but for those that reach from group to group. */
static void geometry_is_read_once(void **state)
{
    (void)state;
    enum { SIZE = 256, GROUPS = 2 };
    VoxelCase given = voxel_case_open("knot", 0, SIZE);
    const uint32_t count = given.model.triangle_count;
    VoxelSort sort = { .by = VOXEL_BY_NORMAL,
                       .groups = GROUPS,
                       .group_depth = (double)SIZE / GROUPS,
                       .spans = gp_alloc(count, sizeof(VoxelSpans)) };
    uint32_t drawn = voxel_sort_count(&given.model, &sort) / 3, reaching = 0;
    sort.indices = gp_alloc(drawn, 3 * sizeof(uint32_t));
    voxel_sort_fill(&given.model, &sort);
    for (uint32_t i = 0; i < count; i++) {
        int axes = 0;
        for (int axis = 0; axis < 3; axis++) {
            int groups = sort.spans[i].end[axis] - sort.spans[i].first[axis];
            axes += groups > 0;
            reaching += groups > 1;
        }
        assert_int_equal(axes, 1);
    }
    assert_int_equal(drawn, count + reaching);
    assert_true(reaching > 0 && reaching < count / 50);

    /* the first list of x holds the first triangle that looks along x and begins below the
     * centre */
    for (uint32_t i = 0; i < count; i++)
        if (sort.spans[i].first[0] == 0 && sort.spans[i].end[0] > 0) {
            assert_memory_equal(sort.indices, given.model.indices + 3 * (size_t)i,
                                3 * sizeof(uint32_t));
            break;
        }
    gp_free(sort.indices);
    gp_free(sort.spans);
    voxel_case_free(&given);
}

/* --- carry ------------------------------------------------------------------------------------ */

/* Two triangles in one voxel: its bit is added twice, and is the next one's. */
static void adding_a_bit_twice_carries(void **state)
{
    (void)state;
    static const float sheets[] = { 4, 4, 9.25f, 12, 4, 9.25f, 4, 12, 9.25f,
                                    4, 4, 9.75f, 12, 4, 9.75f, 4, 12, 9.75f };
    VoxelCase given = voxel_case_of(sheets, 2, 16);
    VoxelSetting setting = with_or(16);
    uint8_t *right = voxel_case_volume(&given, &setting);
    setting.blend = VOXEL_ADD;
    uint8_t *carried = voxel_case_volume(&given, &setting);
    uint64_t count = voxel_count(right, 16);
    assert_in_range(count, 28, 36); /* half of 8 x 8, less or more of the diagonal */
    for (size_t i = 0; i < voxel_bytes(16); i++) {
        const size_t layer = 16 * 16 / 8;
        assert_int_equal(carried[i], i / layer == 10 ? right[i - layer] : 0);
    }
    gp_free(right);
    gp_free(carried);
    voxel_case_free(&given);
}

/* How many voxels adding sets that are not there, and how many it loses. */
typedef struct CarryCase {
    const char *model;
    uint32_t size;
    uint64_t set, lost;
} CarryCase;

static void check_carry(const CarryCase *expected)
{
    const uint32_t size = expected->size;
    VoxelCase given = voxel_case_open(expected->model, 0, size);
    VoxelSetting setting = with_or(size);
    uint8_t *right = voxel_case_volume(&given, &setting);
    setting.blend = VOXEL_ADD;
    uint8_t *carried = voxel_case_volume(&given, &setting);
    assert_int_equal(voxel_count_without(carried, right, size), expected->set);
    assert_int_equal(voxel_count_without(right, carried, size), expected->lost);
    gp_free(right);
    gp_free(carried);
    voxel_case_free(&given);
}

/* Seen along the axis that it faces a surface meets itself in a voxel only where it is thin, or
 * folded. A sphere shows no carry at all; a teapot does where spout, handle and lid meet the
 * body. */
static void shapes_carry_where_they_are_thin(void **state)
{
    (void)state;
    static const CarryCase cases[] = { { "sphere", 32, 0, 0 },
                                       { "teapot", 32, 2, 2 },
                                       { "teapot", 64, 36, 2 } };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        check_carry(&cases[i]);
}

/* Of the models in print the bunny hides the failure, and the buddha shows it. */
static void meshes_carry_where_they_are_thin(void **state)
{
    (void)state;
    static const CarryCase cases[] = { { "meshes/bunny.ply", 64, 0, 0 },
                                       { "meshes/horse.ply", 64, 2, 0 },
                                       { "meshes/lucy_100k.ply", 64, 94, 41 },
                                       { "meshes/happy_buddha.ply", 64, 59, 40 } };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        check_carry(&cases[i]);
}

/* --- directions ------------------------------------------------------------------------------- */

static void compare_axes(const char *shape, uint32_t size, uint64_t *all, uint64_t *lost)
{
    VoxelCase given = voxel_case_open(shape, 0, size);
    VoxelSetting setting = with_or(size);
    uint8_t *three = voxel_case_volume(&given, &setting);
    setting.axes = 1;
    uint8_t *one = voxel_case_volume(&given, &setting);
    *all = voxel_count(three, size);
    *lost = voxel_count_without(three, one, size);
    gp_free(three);
    gp_free(one);
    voxel_case_free(&given);
}

/* Along z alone a cube is its two faces across, the other four are seen edge-on; of a sphere two
 * fifths are gone where it is steep. */
static void one_axis_loses_what_is_edge_on(void **state)
{
    (void)state;
    uint64_t all, lost;
    compare_axes("cube", 32, &all, &lost);
    /* sides are 29.5 voxels long, from 1.25 to 30.75: 30 x 30 centres inside of each face */
    assert_int_equal(all, 30 * 30 * 30 - 28 * 28 * 28);
    assert_int_equal(lost, all - 2 * 30 * 30);
    compare_axes("sphere", 32, &all, &lost);
    assert_int_equal(all, 2176);
    assert_int_equal(lost, 888);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_are_those_of_the_dominant_axis),
        cmocka_unit_test(what_lies_outside_is_not_there),
        cmocka_unit_test(geometry_is_read_once),
        cmocka_unit_test(adding_a_bit_twice_carries),
        cmocka_unit_test(shapes_carry_where_they_are_thin),
        cmocka_unit_test(meshes_carry_where_they_are_thin),
        cmocka_unit_test(one_axis_loses_what_is_edge_on),
    };
    return cmocka_run_group_tests_name("voxel sheets", tests, NULL, NULL);
}
