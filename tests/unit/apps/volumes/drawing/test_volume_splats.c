/* Splatted volumes beside what splats stand for, on every device. */
#include "tests/support/devices.h"
#include "tests/support/splatted_volume.h"
#include "tests/support/unit.h"

enum { FLOATS = 4 * SPLATTED_SIDE * SPLATTED_SIDE };

static const double oblique[3] = { 0.4, 0.2, 1 };
static float drawn[FLOATS], truth[FLOATS], other[FLOATS];

static VolumeSplatSetting usual(void)
{
    return (VolumeSplatSetting)VOLUME_SPLAT_DEFAULTS;
}

/* Asked is 41 dB. */
static void sums_of_kernels_are_near_their_integral(void **state)
{
    (void)state;
    static const double directions[][3] = { { 0.4, 0.2, 1 }, { -1, 0.3, 0.2 }, { 0.1, -1, 0.3 } };
    const VolumeSplatSetting setting = usual();
    for (size_t i = 0; i < GP_COUNT(directions); i++) {
        SplattedVolume volume;
        splatted_open("builtin:marschner-lobb:40", "marschner-lobb", directions[i], 2, &volume);
        splatted_draw(&volume, &setting, drawn);
        splatted_truth_of_method(&volume, &setting, truth);
        const double psnr = splatted_psnr(drawn, truth);
        print_message("# from %zu: %.1f dB\n", i, psnr);
        assert_true(psnr > 45);
        splatted_close(&volume);
    }
}

static void samples_may_be_farther_apart_along_an_axis(void **state)
{
    (void)state;
    const VolumeSplatSetting setting = usual();
    GpError error;
    Field field;
    SplattedVolume volume;
    assert_int_equal(field_open("builtin:marschner-lobb:32", &field, &error), GP_OK);
    field.scale[2] = 2;
    splatted_take(&field, "marschner-lobb", oblique, 1.5, &volume);
    splatted_draw(&volume, &setting, drawn);
    splatted_truth_of_method(&volume, &setting, truth);
    print_message("# %.1f dB\n", splatted_psnr(drawn, truth));
    assert_true(splatted_psnr(drawn, truth) > 41);
    splatted_close(&volume);
}

/* Parallel rays see what a far eye sees through a narrow field. */
static void parallel_rays_are_those_of_a_far_eye(void **state)
{
    (void)state;
    const VolumeSplatSetting setting = usual();
    SplattedVolume volume;
    splatted_open("builtin:marschner-lobb:32", "marschner-lobb", oblique, 2, &volume);
    volume.view.camera.fovy = 0;
    volume.view.camera.height = 40;
    splatted_draw(&volume, &setting, drawn);
    splatted_truth_of_method(&volume, &setting, truth);
    print_message("# %.1f dB\n", splatted_psnr(drawn, truth));
    assert_true(splatted_psnr(drawn, truth) > 41);
    splatted_close(&volume);
}

static void bits_are_the_same_on_every_device(void **state)
{
    (void)state;
    static const struct {
        VoxelFilter filter;
        VoxelSums sums;
        bool alphas, lit;
        uint32_t cull;
        double sides;
    } cases[] = {
        { VOXEL_EWA, VOXEL_HALVES, false, false, 0, 2 },
        { VOXEL_RECONSTRUCTION, VOXEL_FLOATS, true, true, 4, 2 },
        { VOXEL_LOW_PASS, VOXEL_BYTES, false, true, 0, 2 },
        { VOXEL_ADAPTIVE, VOXEL_BYTES_NEAR, false, false, 0, 0.7 }, /* in the volume's corner */
        { VOXEL_BOUNDED, VOXEL_HALVES, true, false, 6, 0.3 },       /* in its midst */
    };
    SplattedVolume volume;
    splatted_open("builtin:marschner-lobb:24", "marschner-lobb", oblique, 2, &volume);
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VolumeSplatSetting setting = usual();
        Frame frame = { .color = NULL };
        splatted_look(&volume, oblique, cases[i].sides);
        volume.view.lit = cases[i].lit;
        setting.filter = cases[i].filter;
        setting.sums = cases[i].sums;
        setting.alphas = cases[i].alphas;
        setting.cull = cases[i].cull;
        splatted_build(&volume, &setting, &frame);
        run_everywhere(&frame);
        frame_free(&frame);
    }
    splatted_close(&volume);
}

/* Where voxels are kept changes no bit of the picture: places, values and footprints are the same
 * numbers, and squares have room for all that a footprint reaches. */
static void modes_draw_one_picture(void **state)
{
    (void)state;
    SplattedVolume volume;
    splatted_open("builtin:marschner-lobb:20", "marschner-lobb", oblique, 1.2, &volume);
    volume.view.lit = true;
    for (VoxelFilter filter = VOXEL_EWA; filter <= VOXEL_LOW_PASS; filter++) {
        VolumeSplatSetting setting = usual();
        setting.filter = filter;
        splatted_draw(&volume, &setting, drawn);
        for (VoxelMode mode = VOXELS_VT; mode < VOXEL_MODES; mode++) {
            Frame frame = { .color = NULL };
            GpError error;
            setting.mode = mode;
            splatted_build(&volume, &setting, &frame);
            run_everywhere(&frame);
            assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, other, &error), GP_OK);
            assert_memory_equal(drawn, other, sizeof drawn);
            frame_free(&frame);
        }
    }
    splatted_close(&volume);
}

/* Table 4: vertex buffers take least, quads more than places with a texture where most is empty. */
static void bytes_are_those_of_table_4(void **state)
{
    (void)state;
    SplattedVolume volume;
    splatted_open("builtin:ball:64", "fog", oblique, 2, &volume);
    const double share =
        (double)field_samples(&volume.field) / (double)volume_splats_count(&volume.splats);
    assert_true(volume_splats_bytes(&volume.splats, VOXELS_VB) == 24);
    assert_true(volume_splats_bytes(&volume.splats, VOXELS_IM) == 24);
    assert_true(volume_splats_bytes(&volume.splats, VOXELS_VT) == 12 + 4 * share);
    assert_true(volume_splats_bytes(&volume.splats, VOXELS_PT) == 12 + 4 * share);
    assert_true(volume_splats_bytes(&volume.splats, VOXELS_QD) == 96);
    splatted_close(&volume);
}

/* Another transfer function shows what it would show from the start, background or not. */
static void a_change_of_the_transfer_function_leaves_no_trace(void **state)
{
    (void)state;
    static const char *const names[] = { "marschner-lobb", "fog", "engine" };
    const VolumeSplatSetting setting = usual();
    GpError error;
    SplattedVolume volume, fresh;
    splatted_open("builtin:ball:24", "bonsai", oblique, 2, &volume);
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        Transfer transfer;
        assert_int_equal(transfer_open(names[i], &volume.field, &transfer, &error), GP_OK);
        assert_int_equal(volume_splats_classify(&volume.splats, &transfer, &error), GP_OK);
        splatted_open("builtin:ball:24", names[i], oblique, 2, &fresh);
        splatted_draw(&volume, &setting, drawn);
        splatted_draw(&fresh, &setting, other);
        assert_memory_equal(drawn, other, sizeof drawn);
        splatted_close(&fresh);
    }
    splatted_close(&volume);
}

/* What is opaque hides what lies behind it, and nothing in front. */
static void a_depth_buffer_cuts_the_volume(void **state)
{
    (void)state;
    static const float black[4] = { 0 };
    const VolumeSplatSetting setting = usual();
    SplattedVolume volume;
    splatted_open("builtin:marschner-lobb:32", "marschner-lobb", (double[3]){ 0, 0, 1 }, 2,
                  &volume);
    splatted_draw(&volume, &setting, drawn);
    for (int hidden = 0; hidden < 2; hidden++) {
        const Camera *camera = &volume.view.camera;
        const double distance = hidden ? 40 : 62 + 20; /* in front of the box, behind it */
        GpError error;
        Frame frame = { .color = NULL };
        GpSurface *depth = frame_surface(&frame, GP_D32F, SPLATTED_SIDE, SPLATTED_SIDE, 1);
        frame_pass(&frame, "depth", NULL, depth, black)->depth.depth_value =
            (float)(camera->far / (camera->far - camera->near) * (1 - camera->near / distance));
        volume.target.depth = depth;
        splatted_build(&volume, &setting, &frame);
        run_list(&frame.list);
        assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, other, &error), GP_OK);
        if (hidden)
            memset(drawn, 0, sizeof drawn);
        assert_memory_equal(drawn, other, sizeof drawn);
        frame_free(&frame);
    }
    splatted_close(&volume);
}

/* Marking opaque pixels changes what is behind them, by less than a step of 8 bits. */
static void opaque_pixels_are_not_drawn_to_again(void **state)
{
    (void)state;
    VolumeSplatSetting setting = usual();
    SplattedVolume volume;
    splatted_open("builtin:ball:32", "checkerboard", oblique, 2, &volume);
    splatted_draw(&volume, &setting, drawn);
    setting.cull = 4;
    splatted_draw(&volume, &setting, other);
    assert_true(memcmp(drawn, other, sizeof drawn) != 0);
    for (int i = 0; i < FLOATS; i++)
        assert_true(drawn[i] - other[i] < 1.0f / 255 && other[i] - drawn[i] < 1.0f / 255);
    splatted_close(&volume);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_of_kernels_are_near_their_integral),
        cmocka_unit_test(samples_may_be_farther_apart_along_an_axis),
        cmocka_unit_test(parallel_rays_are_those_of_a_far_eye),
        cmocka_unit_test(bits_are_the_same_on_every_device),
        cmocka_unit_test(modes_draw_one_picture),
        cmocka_unit_test(bytes_are_those_of_table_4),
        cmocka_unit_test(a_change_of_the_transfer_function_leaves_no_trace),
        cmocka_unit_test(a_depth_buffer_cuts_the_volume),
        cmocka_unit_test(opaque_pixels_are_not_drawn_to_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
