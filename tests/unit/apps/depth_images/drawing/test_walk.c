/* A walk among depth images: what is seen is drawn and nothing else, under shadows, the same bits on every
 * device. */
#include "apps/depth_images/drawing/walk.h"
#include "tests/support/depth/depth_shapes.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <math.h>

enum { WIDTH = 160, HEIGHT = 90, OBJECTS = 12 };

static Walk open_walk(void)
{
    static const char *const names[] = { "builtin:sphere", "builtin:cube" };
    GpError error = { "" };
    DepthModel models[2];
    Walk walk;
    for (int i = 0; i < 2; i++) {
        DepthShape shape = depth_shape_open(names[i], 9, 0);
        models[i] = depth_shape_capture(&shape, 64, 48, 32, true);
        depth_shape_close(&shape);
    }
    if (walk_open(models, 2, OBJECTS, &walk, &error))
        fail_msg("%s", error.text);
    depth_model_free(&models[0]);
    depth_model_free(&models[1]);
    return walk;
}

static Frame make(const Walk *walk, const WalkSetting *setting, const Camera *camera,
                  WalkCounts *counts)
{
    GpError error = { "" };
    Frame frame = { .color = NULL };
    if (walk_add(walk, setting, camera, WIDTH, HEIGHT, &frame, counts, &error))
        fail_msg("%s", error.text);
    return frame;
}

static void read_frame(Frame *frame, float rgba[WIDTH * HEIGHT][4])
{
    run_list(&frame->list);
    assert_int_equal(gp_surface_read_floats(frame->color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    frame_free(frame);
}

static void what_is_outside_the_view_is_left_out(void **state)
{
    (void)state;
    Walk walk = open_walk();
    WalkCounts above, among, away;
    Camera camera = walk_camera(&walk, 0.5);
    Frame frame = make(&walk, &(WalkSetting){ .map = 64 }, &camera, &above);
    frame_free(&frame);
    camera = walk_camera(&walk, 0);
    frame = make(&walk, &(WalkSetting){ .map = 64 }, &camera, &among);
    frame_free(&frame);
    camera.eye[1] += 6;
    for (int k = 0; k < 3; k++)
        camera.at[k] = camera.eye[k] + (k == 1 ? 1 : 0.01);
    frame = make(&walk, &(WalkSetting){ .map = 64 }, &camera, &away);
    frame_free(&frame);
    print_message("# of %d: %u from above, %u from among them, %u into the sky\n", OBJECTS,
                  above.objects, among.objects, away.objects);
    assert_int_equal(above.objects, OBJECTS);
    assert_true(among.objects > 0 && among.objects < OBJECTS && among.triangles < above.triangles);
    assert_int_equal(away.objects, 0);
    walk_close(&walk);
}

/* Objects stand on the ground: each casts a shadow, and most of its outside is as bright as without. */
static void shadows_fall_on_the_ground_and_on_images(void **state)
{
    (void)state;
    static float lit[WIDTH * HEIGHT][4], shadowed[WIDTH * HEIGHT][4];
    Walk walk = open_walk();
    const Camera camera = walk_camera(&walk, 0.5);
    uint32_t darker = 0, brighter = 0, ground = 0;
    Frame frame = make(&walk, &(WalkSetting){ .no_shadows = true }, &camera, NULL);
    read_frame(&frame, lit);
    frame = make(&walk, &(WalkSetting){ .map = 512 }, &camera, NULL);
    read_frame(&frame, shadowed);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const bool is_grass = lit[i][1] > 1.2f * lit[i][0] && lit[i][1] > 1.5f * lit[i][2];
        const bool is_darker = shadowed[i][1] < 0.8f * lit[i][1];
        darker += is_darker;
        ground += is_darker && is_grass;
        brighter += shadowed[i][1] > lit[i][1] + 1.5f / 255;
    }
    print_message("# %u pixels darker, %u of them of the ground\n", darker, ground);
    assert_true(ground > 100 && darker > ground && darker < WIDTH * HEIGHT / 8);
    assert_int_equal(brighter, 0);
    walk_close(&walk);
}

static void every_step_of_the_way_is_drawn(void **state)
{
    (void)state;
    static float rgba[WIDTH * HEIGHT][4];
    Walk walk = open_walk();
    for (int i = 0; i <= 8; i++) {
        const Camera camera = walk_camera(&walk, i / 8.0);
        Frame frame =
            make(&walk, &(WalkSetting){ .map = 64, .step = i % 3 ? 0 : 4 }, &camera, NULL);
        read_frame(&frame, rgba);
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            assert_true(rgba[k][3] == 1);
    }
    walk_close(&walk);
}

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    Walk walk = open_walk();
    const Camera camera = walk_camera(&walk, 0.3);
    Frame frame = make(&walk, &(WalkSetting){ .map = 128 }, &camera, NULL);
    run_everywhere(&frame);
    frame_free(&frame);
    walk_close(&walk);
}

static void a_model_of_nothing_is_refused(void **state)
{
    (void)state;
    GpError error = { "" };
    Walk walk;
    DepthShape shape = depth_shape_open("builtin:cube", 9, 0);
    DepthModel model = depth_shape_capture(&shape, 16, 16, 0, true);
    for (int i = 0; i < 16 * 16; i++)
        model.images[0].front.depth[i] = DEPTH_NOTHING;
    assert_int_equal(walk_open(&model, 1, 4, &walk, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "shows nothing"));
    depth_model_free(&model);
    depth_shape_close(&shape);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_outside_the_view_is_left_out),
        cmocka_unit_test(shadows_fall_on_the_ground_and_on_images),
        cmocka_unit_test(every_step_of_the_way_is_drawn),
        cmocka_unit_test(every_device_draws_the_same_bits),
        cmocka_unit_test(a_model_of_nothing_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
