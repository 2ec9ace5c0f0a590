/* Kernels of opaque voxels that lie in the surfaces of equal values. */
#include "tests/support/devices.h"
#include "tests/support/splatted_volume.h"
#include "tests/support/unit.h"

enum { FLOATS = 4 * SPLATTED_SIDE * SPLATTED_SIDE };

static const double oblique[3] = { 0.4, 0.2, 1 };
static float drawn[FLOATS], truth[FLOATS];

/* A ball that is opaque from half of its values on, four pixels a sample. */
static void open_opaque_ball(SplattedVolume *volume)
{
    GpError error;
    splatted_open("builtin:ball:24", "fog", oblique, 2, volume);
    volume->transfer =
        (Transfer){ .count = 2, .stops = { { 127, { 1, 1, 1, 0 } }, { 128, { 1, 1, 1, 0.97 } } } };
    assert_int_equal(volume_splats_classify(&volume->splats, &volume->transfer, &error), GP_OK);
    volume->view.camera.fovy = 0;
    volume->view.camera.height = 30;
}

/* Failure: round kernels reach out of the surface, and blur its silhouette. Remedy: flat ones. */
static void round_kernels_blur_a_silhouette_and_flat_ones_less(void **state)
{
    (void)state;
    VolumeSplatSetting setting = VOLUME_SPLAT_DEFAULTS;
    double psnr[2];
    SplattedVolume volume;
    open_opaque_ball(&volume);
    splatted_truth_of_data(&volume, truth);
    for (int flat = 0; flat < 2; flat++) {
        setting.flat = flat;
        splatted_draw(&volume, &setting, drawn);
        psnr[flat] = splatted_psnr(drawn, truth);
    }
    print_message("# round %.1f dB, flat %.1f dB\n", psnr[0], psnr[1]);
    assert_true(psnr[1] > psnr[0] + 0.5);
    splatted_close(&volume);
}

/* What is not opaque keeps its round kernel, bit for bit. */
static void translucent_voxels_stay_round(void **state)
{
    (void)state;
    VolumeSplatSetting setting = VOLUME_SPLAT_DEFAULTS;
    SplattedVolume volume;
    splatted_open("builtin:ball:24", "fog", oblique, 2, &volume);
    splatted_draw(&volume, &setting, truth);
    setting.flat = true;
    splatted_draw(&volume, &setting, drawn);
    assert_memory_equal(drawn, truth, sizeof drawn);
    splatted_close(&volume);
}

static void bits_are_the_same_on_every_device(void **state)
{
    (void)state;
    SplattedVolume volume;
    open_opaque_ball(&volume);
    for (VoxelFilter filter = VOXEL_EWA; filter <= VOXEL_LOW_PASS; filter++) {
        VolumeSplatSetting setting = VOLUME_SPLAT_DEFAULTS;
        Frame frame = { .color = NULL };
        setting.flat = true;
        setting.filter = filter;
        splatted_build(&volume, &setting, &frame);
        run_everywhere(&frame);
        frame_free(&frame);
    }
    splatted_close(&volume);
}

static void what_has_no_program_is_refused(void **state)
{
    (void)state;
    static const VolumeSplatSetting wrong[] = {
        { .sheets = SHEETS_IMAGE, .mode = VOXELS_PT },
        { .after = true, .mode = VOXELS_QD },
        { .after = true, .sheets = SHEETS_IMAGE },
        { .after = true, .alphas = true },
        { .flat = true, .after = true },
        { .flat = true, .sheets = SHEETS_IMAGE },
        { .flat = true, .mode = VOXELS_VT },
    };
    SplattedVolume volume;
    splatted_open("builtin:ball:8", "fog", oblique, 2, &volume);
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        Frame frame = { .color = NULL };
        GpError error = { "" };
        assert_int_equal(volume_splats_add(&volume.splats, &volume.view, &wrong[i], &volume.target,
                                           &frame, &error),
                         GP_ERROR_UNSUPPORTED);
        assert_non_null(strstr(error.text, "expected"));
        frame_free(&frame);
    }
    splatted_close(&volume);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(round_kernels_blur_a_silhouette_and_flat_ones_less),
        cmocka_unit_test(translucent_voxels_stay_round),
        cmocka_unit_test(bits_are_the_same_on_every_device),
        cmocka_unit_test(what_has_no_program_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
