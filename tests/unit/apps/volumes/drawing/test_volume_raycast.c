/* Rays through volumes: close to the truth of the data however they are looked at, and the same
 * bits on every device. */
#include "apps/volumes/drawing/raycast.h"
#include "tests/support/volume_case.h"

static const Transfer shells = { 6,
                                 { { 0, { 0, 0, 0, 0 } },
                                   { 100, { .1, .3, 1, 0 } },
                                   { 128, { .2, .8, .9, .1 } },
                                   { 160, { 1, .8, .2, .2 } },
                                   { 200, { 1, .2, .1, 0 } },
                                   { 255, { 1, .2, .1, .05 } } } };

#define TO_MIDDLE .at = { 23.5, 23.5, 23.5 }, .up = { 0, 1, 0 }, .near = 1, .far = 500

static const struct {
    const char *what;
    Camera camera;
    double scale[3], step, psnr;
} views[] = {
    { "from outside", { .eye = { 62, 43, 105 }, .fovy = 40, TO_MIDDLE }, { 1, 1, 1 }, 1, 52 },
    { "short steps", { .eye = { 62, 43, 105 }, .fovy = 40, TO_MIDDLE }, { 1, 1, 1 }, .25, 60 },
    { "from behind", { .eye = { -62, 3, -105 }, .fovy = 40, TO_MIDDLE }, { 1, 1, 1 }, .5, 52 },
    { "along an axis", { .eye = { 23.5, 23.5, 120 }, .fovy = 35, TO_MIDDLE }, { 1, 1, 1 }, .5, 52 },
    { "from inside", { .eye = { 20, 28, 30 }, .fovy = 90, TO_MIDDLE }, { 1, 1, 1 }, .5, 48 },
    { "parallel", { .eye = { 62, 43, 105 }, .height = 80, TO_MIDDLE }, { 1, 1, 1 }, .5, 52 },
    { "parallel, along an axis",
      { .eye = { 100, 23.5, 23.5 }, .height = 60, TO_MIDDLE },
      { 1, 1, 1 },
      .25,
      52 },
    { "uneven", { .eye = { 92, 63, 145 }, .fovy = 50, TO_MIDDLE }, { 1, 1.5, 2.2 }, .5, 52 },
    { "cut by the planes",
      { .eye = { 62, 43, 105 },
        .at = { 23.5, 23.5, 23.5 },
        .up = { 0, 1, 0 },
        .fovy = 40,
        .near = 80,
        .far = 105 },
      { 1, 1, 1 },
      .5,
      52 },
};

static RaycastVolume open_volume(const Field *field, const Transfer *transfer)
{
    RaycastVolume volume;
    GpError error = { "" };
    if (raycast_open(field, &volume, &error))
        fail_msg("%s", error.text);
    raycast_classify(&volume, transfer);
    return volume;
}

static void add_to(RaycastVolume *volume, const VolumeView *view, double step,
                   const VolumeTarget *target, Frame *frame)
{
    GpError error = { "" };
    if (raycast_add(volume, view, &(RaycastSetting){ .step = step }, target, frame, &error))
        fail_msg("%s", error.text);
}

static void every_view_is_near_the_truth(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(views); i++) {
        Field field = volume_field("builtin:marschner-lobb:48", views[i].scale);
        RaycastVolume volume = open_volume(&field, &shells);
        const VolumeView view = volume_view(views[i].camera);
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
        add_to(&volume, &view, views[i].step, &target, &frame);
        run_list(&frame.list);
        const VolumeSource source = { &field, &shells };
        const double psnr = volume_psnr(&source, &view, NULL, target.color);
        print_message("# %s: %.1f dB\n", views[i].what, psnr);
        failed += !(psnr >= views[i].psnr);
        frame_free(&frame);
        raycast_close(&volume);
        field_free(&field);
    }
    assert_int_equal(failed, 0);
}

/* A plane that faces the eye, and a ray whose end it is, between steps and between samples. */
static void opaque_things_end_rays(void **state)
{
    (void)state;
    static float depth[VOLUME_SIDE * VOLUME_SIDE];
    for (int parallel = 0; parallel < 2; parallel++) {
        Field field = volume_field("builtin:marschner-lobb:48", NULL);
        RaycastVolume volume = open_volume(&field, &shells);
        const VolumeView view = volume_view(views[parallel ? 5 : 0].camera);
        Frame frame = { .color = NULL };
        VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
        target.depth = frame_surface(&frame, GP_D32F, VOLUME_SIDE, VOLUME_SIDE, 1);
        for (int i = 0; i < VOLUME_SIDE * VOLUME_SIDE; i++) {
            const double distance = 75 + (i % VOLUME_SIDE) * 0.6 + (i / VOLUME_SIDE) % 7;
            const double near = view.camera.near, far = view.camera.far;
            depth[i] = (float)(parallel ? (distance - near) / (far - near)
                                        : far * (distance - near) / (distance * (far - near)));
        }
        memcpy(target.depth->level[0].texels, depth, sizeof depth);
        add_to(&volume, &view, 0.5, &target, &frame);
        run_list(&frame.list);
        const VolumeSource source = { &field, &shells };
        const double psnr = volume_psnr(&source, &view, depth, target.color);
        print_message("# %.1f dB\n", psnr);
        assert_true(psnr > 50);
        assert_true(volume_psnr(&source, &view, NULL, target.color) < 30);
        frame_free(&frame);
        raycast_close(&volume);
        field_free(&field);
    }
}

static void frames_have_the_same_bits_everywhere(void **state)
{
    (void)state;
    for (int lit = 0; lit < 2; lit++) {
        Field field = volume_field("builtin:ball:33", NULL);
        static const Transfer skin = { 2, { { 30, { 1, .5, .2, 0 } }, { 160, { 1, 1, .5, .4 } } } };
        RaycastVolume volume = open_volume(&field, &skin);
        VolumeView view = volume_view((Camera){ .eye = { 45, 35, 60 },
                                                .at = { 16, 16, 16 },
                                                .up = { 0, 1, 0 },
                                                .fovy = 40,
                                                .near = 1,
                                                .far = 200 });
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A8R8G8B8);
        view.lit = lit;
        add_to(&volume, &view, 0.7, &target, &frame);
        run_everywhere(&frame);
        frame_free(&frame);
        raycast_close(&volume);
        field_free(&field);
    }
}

static uint64_t hash_with(const Field *field, const Transfer *transfer, bool skips)
{
    RaycastVolume volume = open_volume(field, transfer);
    const VolumeView view = volume_view(views[0].camera);
    Frame frame = { .color = NULL };
    const VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
    if (!skips)
        memset(volume.shown, 1, bricks_total(&volume.bricks));
    add_to(&volume, &view, 1, &target, &frame);
    run_list(&frame.list);
    const uint64_t hash = gp_surface_hash(target.color);
    frame_free(&frame);
    raycast_close(&volume);
    return hash;
}

static void what_is_passed_over_would_have_added_nothing(void **state)
{
    (void)state;
    static const Transfer thin = {
        4, { { 0, { 0 } }, { 150, { 1, .8, .2, 0 } }, { 151, { 1, .8, .2, .9 } }, { 154, { 0 } } }
    };
    Field field = volume_field("builtin:marschner-lobb:48", NULL);
    assert_int_equal(hash_with(&field, &shells, true), hash_with(&field, &shells, false));
    assert_int_equal(hash_with(&field, &thin, true), hash_with(&field, &thin, false));
    field_free(&field);
}

/* Straight through 11 samples of one value: 10 slabs, whatever the step, and the last one short. */
static void an_even_slab_takes_what_its_opacity_says(void **state)
{
    (void)state;
    static const Transfer even = { 1, { { 0, { 1, .5, .25, .2 } } } };
    static uint8_t samples[11 * 11 * 11];
    const Field field = { { 11, 11, 11 }, { 1, 1, 1 }, samples, 0, 255 };
    static const double steps[] = { 1, 0.3, 2.7, 7, 20 };
    for (size_t i = 0; i < GP_COUNT(steps); i++) {
        RaycastVolume volume = open_volume(&field, &even);
        const VolumeView view = volume_view((Camera){ .eye = { 5, 5, 40 },
                                                      .at = { 5, 5, 5 },
                                                      .up = { 0, 1, 0 },
                                                      .height = 8,
                                                      .near = 1,
                                                      .far = 100 });
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
        float rgba[4];
        add_to(&volume, &view, steps[i], &target, &frame);
        run_list(&frame.list);
        gp_surface_read_floats(target.color, 0, &(GpRect){ 30, 30, 31, 31 }, rgba, NULL);
        assert_true(fabs((double)rgba[3] - (1 - pow(0.8, 10))) < 2e-6);
        assert_true(fabs((double)rgba[1] - 0.5 * (1 - pow(0.8, 10))) < 2e-6);
        frame_free(&frame);
        raycast_close(&volume);
    }
}

static void a_new_transfer_function_is_as_the_first(void **state)
{
    (void)state;
    static const Transfer other = { 2, { { 60, { 0, 1, 0, 0 } }, { 80, { 0, 1, 1, 1 } } } };
    Field field = volume_field("builtin:marschner-lobb:48", NULL);
    RaycastVolume volume = open_volume(&field, &other);
    const VolumeView view = volume_view(views[0].camera);
    uint64_t hash = 0;
    for (int i = 0; i < 2; i++) {
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
        add_to(&volume, &view, 1, &target, &frame);
        run_list(&frame.list);
        hash = gp_surface_hash(target.color);
        frame_free(&frame);
        raycast_classify(&volume, &shells);
    }
    assert_int_equal(hash, hash_with(&field, &shells, true));
    raycast_close(&volume);
    field_free(&field);
}

/* Thin volumes, eyes that look away, and volumes behind the eye draw nothing; what is too large
 * says so. */
static void what_cannot_be_seen_is_not(void **state)
{
    (void)state;
    static uint8_t samples[5 * 5];
    static const Transfer even = { 1, { { 0, { 1, .5, .25, .2 } } } };
    const Field flat = { { 5, 5, 1 }, { 1, 1, 1 }, samples, 0, 255 };
    Field field = volume_field("builtin:ball:16", NULL);
    const Field *fields[] = { &flat, &field, &field };
    static const double at[3][3] = { { 5, 5, 5 }, { 5, 5, 50 }, { 40, 5, 20 } };
    for (int i = 0; i < 3; i++) {
        RaycastVolume volume = open_volume(fields[i], &even);
        const VolumeView view = volume_view((Camera){ .eye = { 5, 5, 40 },
                                                      .at = { at[i][0], at[i][1], at[i][2] },
                                                      .up = { 0, 1, 0 },
                                                      .fovy = 50,
                                                      .near = 1,
                                                      .far = 100 });
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A8R8G8B8);
        add_to(&volume, &view, 1, &target, &frame);
        run_list(&frame.list);
        for (int k = 0; k < VOLUME_SIDE * VOLUME_SIDE; k++)
            assert_int_equal(((uint32_t *)(void *)target.color->level[0].texels)[k], 0);
        frame_free(&frame);
        raycast_close(&volume);
    }
    field_free(&field);
    const Field large = { { 1024, 1024, 1024 }, { 1, 1, 1 }, samples, 0, 255 };
    RaycastVolume volume;
    GpError error = { "" };
    assert_int_equal(raycast_open(&large, &volume, &error), GP_ERROR_UNSUPPORTED);
    assert_string_equal(error.text, "a volume of 1024 x 1024 x 1024 samples: expected what 8192 x "
                                    "8192 texels have room for");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_view_is_near_the_truth),
        cmocka_unit_test(opaque_things_end_rays),
        cmocka_unit_test(frames_have_the_same_bits_everywhere),
        cmocka_unit_test(what_is_passed_over_would_have_added_nothing),
        cmocka_unit_test(an_even_slab_takes_what_its_opacity_says),
        cmocka_unit_test(a_new_transfer_function_is_as_the_first),
        cmocka_unit_test(what_cannot_be_seen_is_not),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
