/* Volumes as planes between their slices: close to the truth of the data from all sides, and the
 * same bits on every device. */
#include "apps/volumes/drawing/slices.h"
#include "tests/support/volume_case.h"

static const Transfer shells = { 4,
                                 { { 100, { .1, .3, 1, 0 } },
                                   { 128, { .2, .8, .9, .1 } },
                                   { 160, { 1, .8, .2, .2 } },
                                   { 200, { 1, .2, .1, 0 } } } };

#define TO_MIDDLE .at = { 23.5, 23.5, 23.5 }, .up = { 0, 1, 0 }, .near = 1, .far = 500

static const struct {
    const char *what;
    Camera camera;
    double scale[3], spacing, psnr;
} views[] = {
    { "across z", { .eye = { 62, 43, 105 }, .fovy = 40, TO_MIDDLE }, { 1, 1, 1 }, 1, 42 },
    { "between slices", { .eye = { 62, 43, 105 }, .fovy = 40, TO_MIDDLE }, { 1, 1, 1 }, .25, 54 },
    { "across z, from behind",
      { .eye = { -62, 3, -105 }, .fovy = 40, TO_MIDDLE },
      { 1, 1, 1 },
      .5,
      48 },
    { "across x", { .eye = { 120, 33, 55 }, .fovy = 40, TO_MIDDLE }, { 1, 1, 1 }, .5, 48 },
    { "across y",
      { .eye = { 33, -120, 55 },
        .at = { 23.5, 23.5, 23.5 },
        .up = { 0, 0, 1 },
        .fovy = 40,
        .near = 1,
        .far = 500 },
      { 1, 1, 1 },
      .5,
      48 },
    { "from inside", { .eye = { 20, 28, 30 }, .fovy = 60, TO_MIDDLE }, { 1, 1, 1 }, .25, 40 },
    { "parallel", { .eye = { 62, 43, 105 }, .height = 80, TO_MIDDLE }, { 1, 1, 1 }, .5, 48 },
    { "uneven", { .eye = { 92, 63, 145 }, .fovy = 50, TO_MIDDLE }, { 1, 1.5, 2.2 }, .25, 48 },
};

static SlicesVolume open_volume(const Field *field, const Transfer *transfer)
{
    SlicesVolume volume;
    GpError error = { "" };
    if (slices_open(field, &volume, &error))
        fail_msg("%s", error.text);
    slices_classify(&volume, transfer);
    return volume;
}

static void add_to(SlicesVolume *volume, const VolumeView *view, const SlicesSetting *setting,
                   const VolumeTarget *target, Frame *frame)
{
    GpError error = { "" };
    if (slices_add(volume, view, setting, target, frame, &error))
        fail_msg("%s", error.text);
}

static void every_view_is_near_the_truth(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(views); i++) {
        Field field = volume_field("builtin:marschner-lobb:48", views[i].scale);
        SlicesVolume volume = open_volume(&field, &shells);
        const VolumeView view = volume_view(views[i].camera);
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
        add_to(&volume, &view, &(SlicesSetting){ .spacing = views[i].spacing }, &target, &frame);
        run_list(&frame.list);
        const VolumeSource source = { &field, &shells };
        const double psnr = volume_psnr(&source, &view, NULL, target.color);
        print_message("# %s: %.1f dB\n", views[i].what, psnr);
        failed += !(psnr >= views[i].psnr);
        frame_free(&frame);
        slices_close(&volume);
        field_free(&field);
    }
    assert_int_equal(failed, 0);
}

/* To half of a slab. */
static void opaque_things_hide_planes(void **state)
{
    (void)state;
    static float depth[VOLUME_SIDE * VOLUME_SIDE];
    Field field = volume_field("builtin:marschner-lobb:48", NULL);
    SlicesVolume volume = open_volume(&field, &shells);
    const VolumeView view = volume_view(views[0].camera);
    Frame frame = { .color = NULL };
    VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
    target.depth = frame_surface(&frame, GP_D32F, VOLUME_SIDE, VOLUME_SIDE, 1);
    for (int i = 0; i < VOLUME_SIDE * VOLUME_SIDE; i++) {
        const double distance = 75 + (i % VOLUME_SIDE) * 0.6, near = 1, far = 500;
        depth[i] = (float)(far * (distance - near) / (distance * (far - near)));
    }
    memcpy(target.depth->level[0].texels, depth, sizeof depth);
    add_to(&volume, &view, &(SlicesSetting){ .spacing = 0.125 }, &target, &frame);
    run_list(&frame.list);
    const VolumeSource source = { &field, &shells };
    const double psnr = volume_psnr(&source, &view, depth, target.color);
    print_message("# %.1f dB\n", psnr);
    assert_true(psnr > 45);
    assert_true(volume_psnr(&source, &view, NULL, target.color) < 30);
    assert_memory_equal(target.depth->level[0].texels, depth, sizeof depth);
    frame_free(&frame);
    slices_close(&volume);
    field_free(&field);
}

static void frames_have_the_same_bits_everywhere(void **state)
{
    (void)state;
    Field field = volume_field("builtin:ball:33", NULL);
    static const Transfer skin = { 2, { { 30, { 1, .5, .2, 0 } }, { 160, { 1, 1, .5, .9 } } } };
    SlicesVolume volume = open_volume(&field, &skin);
    for (int lit = 0; lit < 2; lit++) {
        VolumeView view = volume_view((Camera){ .eye = { 45, 35, 60 },
                                                .at = { 16, 16, 16 },
                                                .up = { 0, 1, 0 },
                                                .fovy = 40,
                                                .near = 1,
                                                .far = 200 });
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A8R8G8B8);
        view.lit = lit;
        add_to(&volume, &view, &(SlicesSetting){ .cull = 4 }, &target, &frame);
        run_everywhere(&frame);
        frame_free(&frame);
    }
    slices_close(&volume);
    field_free(&field);
}

static uint64_t hash_with(const Field *field, bool skips, uint32_t cull, double *psnr)
{
    static const Transfer thick = { 2, { { 120, { 1, .5, .2, 0 } }, { 160, { 1, 1, .5, .9 } } } };
    const VolumeSource source = { field, &thick };
    SlicesVolume volume = open_volume(field, &thick);
    const VolumeView view = volume_view(views[0].camera);
    Frame frame = { .color = NULL };
    const VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
    if (!skips)
        memset(volume.shown, 1, bricks_total(&volume.bricks));
    add_to(&volume, &view, &(SlicesSetting){ .cull = cull }, &target, &frame);
    run_list(&frame.list);
    *psnr = volume_psnr(&source, &view, NULL, target.color);
    const uint64_t hash = gp_surface_hash(target.color);
    frame_free(&frame);
    slices_close(&volume);
    return hash;
}

/* Cells that are left out would have added nothing; pixels that are marked opaque, next to
 * nothing. */
static void what_is_left_out_does_not_show(void **state)
{
    (void)state;
    double all, skipped, culled;
    Field field = volume_field("builtin:marschner-lobb:48", NULL);
    const uint64_t hash = hash_with(&field, false, 1000, &all);
    assert_int_equal(hash, hash_with(&field, true, 1000, &skipped));
    assert_int_not_equal(hash, hash_with(&field, true, 2, &culled));
    assert_true(all > 30 && fabs(culled - all) < 0.1);
    field_free(&field);
}

/* Straight and askew through 11 samples of one value. */
static void an_even_slab_takes_what_its_opacity_says(void **state)
{
    (void)state;
    static const Transfer even = { 1, { { 0, { 1, .5, .25, .2 } } } };
    static uint8_t samples[11 * 11 * 11];
    const Field field = { { 11, 11, 11 }, { 1, 1, 1 }, samples, 0, 255 };
    for (int askew = 0; askew < 2; askew++) {
        SlicesVolume volume = open_volume(&field, &even);
        const VolumeView view = volume_view((Camera){ .eye = { 5 + askew * 15, 5, 25 },
                                                      .at = { 5, 5, 5 },
                                                      .up = { 0, 1, 0 },
                                                      .height = 8,
                                                      .near = 1,
                                                      .far = 100 });
        Frame frame = { .color = NULL };
        const VolumeTarget target = volume_target(&frame, GP_A32B32G32R32F);
        float rgba[4];
        const double expected = 1 - pow(0.8, askew ? 12.5 : 10);
        add_to(&volume, &view, &(SlicesSetting){ .spacing = 0.5 }, &target, &frame);
        run_list(&frame.list);
        gp_surface_read_floats(target.color, 0, &(GpRect){ 35, 36, 36, 37 }, rgba, NULL);
        assert_true(fabs((double)rgba[3] - expected) < 2e-6);
        assert_true(fabs((double)rgba[1] - 0.5 * expected) < 2e-6);
        frame_free(&frame);
        slices_close(&volume);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_view_is_near_the_truth),
        cmocka_unit_test(opaque_things_hide_planes),
        cmocka_unit_test(frames_have_the_same_bits_everywhere),
        cmocka_unit_test(what_is_left_out_does_not_show),
        cmocka_unit_test(an_even_slab_takes_what_its_opacity_says),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
