/* Two models in one volume: where the second lies, and what becomes of their voxels. */
#include "apps/techniques/voxel/inputs/pair.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

enum { SIZE = 32, BYTES = SIZE * SIZE * SIZE / 8 };

static const VoxelSetting solid = { .kind = VOXEL_SOLID, .size = SIZE, .bits = 1, .axes = 3 };

static void open_scene(const char *path, VoxelScene *scene)
{
    GpError error = { "" };
    if (voxel_scene_open(path, scene, &error))
        fail_msg("%s: %s", path, error.text);
}

/* The cube from -1 to 1 as voxels 12 to 19. */
static void open_placed_cube(VoxelScene *scene)
{
    open_scene("builtin:cube", scene);
    scene->is_placed = true;
    scene->scale = 4;
    for (int k = 0; k < 3; k++)
        scene->offset[k] = SIZE / 2.0;
}

static void draw(const VoxelPair *pair, const VoxelSetting *setting, Frame *frame,
                 VoxelPairMade *made)
{
    GpError error = { "" };
    GpDevice *device = NULL;
    *frame = (Frame){ .color = NULL };
    if (voxel_pair_build(pair, setting, frame, made, &error))
        fail_msg("%s", error.text);
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, &error), GP_OK);
    if (gp_device_run(device, &frame->list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
}

static void the_second_lies_where_it_is_put(void **state)
{
    (void)state;
    static const struct {
        VoxelPlace place;
        VoxelCombine combine;
        uint64_t voxels;
    } cases[] = {
        { { 0, { 0.5, 0, 0 } }, VOXEL_UNION, 12 * 8 * 8 },
        { { 0, { 0.5, 0, 0 } }, VOXEL_INTERSECTION, 4 * 8 * 8 },
        { { 0, { 0.5, 0, 0 } }, VOXEL_DIFFERENCE, 4 * 8 * 8 },
        { { 0, { 0.5, 0, 0 } }, VOXEL_TOUCHING, 4 * 8 * 8 },
        { { 0, { 0, -0.5, 0.25 } }, VOXEL_TOUCHING, 8 * 4 * 6 },
        { { 0, { 0, 0, 1 } }, VOXEL_TOUCHING, 0 },
        { { 0, { 0, 0, 3 } }, VOXEL_TOUCHING, 0 }, /* beyond the volume */
        { { 0, { 0, 0, 3 } }, VOXEL_UNION, 512 },  /* and cut off there */
        { { 0.5, { 0, 0, 0 } }, VOXEL_DIFFERENCE, 512 - 64 },
        { { 0.5, { 0.25, 0, 0 } }, VOXEL_INTERSECTION, 64 },
        { { 0.5, { 0.5, 0, 0 } }, VOXEL_INTERSECTION, 32 },
        { { 2, { 0, 0, 0 } }, VOXEL_DIFFERENCE, 0 },
    };
    VoxelScene a, b;
    open_placed_cube(&a);
    open_scene("builtin:cube", &b);
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        const VoxelPair pair = { .scenes = { &a, &b },
                                 .names = { "a", "b" },
                                 .place = cases[i].place,
                                 .combine = cases[i].combine };
        Frame frame;
        VoxelPairMade made;
        draw(&pair, &solid, &frame, &made);
        assert_int_equal(flat_texture_count(&made.result), cases[i].voxels);
        assert_int_equal(voxel_count_range(&made.result, &made.range), cases[i].voxels);
        frame_free(&frame);
    }
    voxel_scene_close(&a);
    voxel_scene_close(&b);
}

static void results_are_what_their_models_have(void **state)
{
    (void)state;
    static const char *const others[] = { "builtin:torus", "implicit:x^2+y^2+z^2-1" };
    static uint8_t bits[3][BYTES];
    VoxelScene a, b;
    open_scene("builtin:knot", &a);
    for (size_t i = 0; i < GP_COUNT(others); i++) {
        open_scene(others[i], &b);
        for (VoxelCombine combine = VOXEL_UNION; combine <= VOXEL_TOUCHING; combine++) {
            const VoxelPair pair = { .scenes = { &a, &b },
                                     .names = { "a", "b" },
                                     .place = { 0, { 0.1, 0, 0.05 } },
                                     .combine = combine };
            Frame frame;
            VoxelPairMade made;
            draw(&pair, &solid, &frame, &made);
            flat_texture_read(&made.volumes[0], bits[0]);
            flat_texture_read(&made.volumes[1], bits[1]);
            flat_texture_read(&made.result, bits[2]);
            for (int k = 0; k < BYTES; k++)
                assert_int_equal(bits[2][k], combine == VOXEL_UNION ? bits[0][k] | bits[1][k]
                                             : combine == VOXEL_DIFFERENCE
                                                 ? bits[0][k] & (uint8_t)~bits[1][k]
                                                 : bits[0][k] & bits[1][k]);
            assert_true(flat_texture_count(&made.result) > 10);
            frame_free(&frame);
        }
        voxel_scene_close(&b);
    }
    voxel_scene_close(&a);
}

/* However they lie, both are inside, and one of them reaches the sides. */
static void the_volume_holds_both(void **state)
{
    (void)state;
    static const VoxelPlace places[] = { { 0, { 0, 0, 0 } },
                                         { 0, { 3, -2, 0.5 } },
                                         { 0.2, { 0, 0, -2 } },
                                         { 7, { 0.1, 0, 0 } },
                                         { 1.5, { -1, 1, 1 } } };
    VoxelScene a, b;
    open_scene("builtin:cone", &a);
    open_scene("builtin:teapot", &b);
    for (size_t i = 0; i < GP_COUNT(places); i++) {
        const VoxelPair pair = {
            .scenes = { &a, &b }, .names = { "a", "b" }, .place = places[i], .combine = VOXEL_UNION
        };
        const VoxelSetting surface = { .size = SIZE, .bits = 1, .axes = 3 };
        Frame frame;
        VoxelPairMade made;
        draw(&pair, &surface, &frame, &made);
        uint32_t longest = 0;
        for (int k = 0; k < 3; k++) {
            assert_true(made.around.low[k] >= 1 && made.around.end[k] <= SIZE - 1);
            const uint32_t side = made.around.end[k] - made.around.low[k];
            longest = side > longest ? side : longest;
        }
        assert_true(longest >= SIZE - 3);
        assert_int_equal(voxel_count_range(&made.result, &made.around),
                         flat_texture_count(&made.result));
        frame_free(&frame);
    }
    voxel_scene_close(&a);
    voxel_scene_close(&b);
}

static void one_model_may_be_smaller_than_its_volume(void **state)
{
    (void)state;
    VoxelScene a;
    open_scene("builtin:cube", &a);
    /* a quarter of 29.5 voxels, from the centre: 12.3125 to 19.6875 */
    const VoxelPair pair = { .scenes = { &a }, .names = { "a" }, .place = { 0.25, { 0, 0, 0 } } };
    Frame frame;
    VoxelPairMade made;
    draw(&pair, &solid, &frame, &made);
    assert_int_equal(flat_texture_count(&made.result), 8 * 8 * 8);
    frame_free(&frame);
    voxel_scene_close(&a);
}

static void what_cannot_be_combined_is_refused(void **state)
{
    (void)state;
    static const struct {
        VoxelSetting setting;
        VoxelCombine combine;
        double twist;
        const char *part;
    } cases[] = {
        { { .method = VOXEL_SHEETS, .bits = 16, .axes = 3 }, VOXEL_UNION, 0, "not 16" },
        { { .method = VOXEL_SHEETS, .bits = 8, .axes = 3 }, VOXEL_TOUCHING, 0, "not 8" },
        { { .bits = 1, .axes = 3 }, VOXEL_UNION, 5, "--twist" },
        { { .bits = 1, .kind = VOXEL_SOLID, .axes = 3 }, VOXEL_UNION, 0, "second: a parametric" },
    };
    VoxelScene a, b;
    open_scene("builtin:cube", &a);
    open_scene("parametric:torus", &b);
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        const VoxelPair pair = { .scenes = { &a, &b },
                                 .names = { "first", "second" },
                                 .combine = cases[i].combine };
        VoxelSetting setting = cases[i].setting;
        Frame frame = { .color = NULL };
        VoxelPairMade made;
        GpError error = { "" };
        setting.size = SIZE;
        a.twist = cases[i].twist;
        assert_int_equal(voxel_pair_build(&pair, &setting, &frame, &made, &error),
                         GP_ERROR_INVALID);
        if (!strstr(error.text, cases[i].part))
            fail_msg("case %zu: %s", i, error.text);
        frame_free(&frame);
    }
    voxel_scene_close(&a);
    voxel_scene_close(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_second_lies_where_it_is_put),
        cmocka_unit_test(results_are_what_their_models_have),
        cmocka_unit_test(the_volume_holds_both),
        cmocka_unit_test(one_model_may_be_smaller_than_its_volume),
        cmocka_unit_test(what_cannot_be_combined_is_refused),
    };
    return cmocka_run_group_tests_name("voxel pair", tests, NULL, NULL);
}
