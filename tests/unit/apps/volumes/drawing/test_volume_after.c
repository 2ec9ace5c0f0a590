/* Densities that are classified in the sheet, beside what the data are. */
#include "tests/support/devices.h"
#include "tests/support/splatted_volume.h"
#include "tests/support/unit.h"

enum { FLOATS = 4 * SPLATTED_SIDE * SPLATTED_SIDE };

static const double oblique[3] = { 0.4, 0.2, 1 };
static float drawn[FLOATS], truth[FLOATS];

static VolumeSplatSetting after(void)
{
    VolumeSplatSetting setting = VOLUME_SPLAT_DEFAULTS;
    setting.after = true;
    return setting;
}

/* Failure: voxels that are classified before they are splatted blur what a transfer function sets
 * apart. Remedy: classification after it. Asked is 36 dB. */
static void classified_voxels_blur_and_classified_sheets_do_not(void **state)
{
    (void)state;
    static const double directions[][3] = { { 0.4, 0.2, 1 }, { -1, 0.3, 0.2 }, { 0.1, -1, 0.3 } };
    const VolumeSplatSetting printed = VOLUME_SPLAT_DEFAULTS, remedy = after();
    for (size_t i = 0; i < GP_COUNT(directions); i++) {
        SplattedVolume volume;
        splatted_open("builtin:marschner-lobb:64", "marschner-lobb", directions[i], 2, &volume);
        volume.view.camera.fovy = 0;
        volume.view.camera.height = 40;
        splatted_truth_of_data(&volume, truth);
        splatted_draw(&volume, &printed, drawn);
        const double before = splatted_psnr(drawn, truth);
        splatted_draw(&volume, &remedy, drawn);
        print_message("# classified before %.1f dB, after %.1f dB\n", before,
                      splatted_psnr(drawn, truth));
        assert_true(splatted_psnr(drawn, truth) > 36);
        assert_true(splatted_psnr(drawn, truth) > before + 2);
        splatted_close(&volume);
    }
}

/* The volume ends at its first and last samples, and a slab of one value has that value's
 * opacity. */
static void a_slab_of_one_value_is_as_opaque_as_it_is_thick(void **state)
{
    (void)state;
    const VolumeSplatSetting setting = after();
    Field field = { .size = { 40, 40, 5 }, .scale = { 1, 1, 1.5 }, .most = 255 };
    SplattedVolume volume;
    field.value = gp_alloc(field_samples(&field), 1);
    assert_non_null(field.value);
    memset(field.value, 255, field_samples(&field));
    splatted_take(&field, "fog", (double[3]){ 0, 0, 1 }, 2, &volume);
    splatted_draw(&volume, &setting, drawn);
    const float alpha = drawn[4 * (SPLATTED_SIDE / 2 * SPLATTED_SIDE + SPLATTED_SIDE / 2) + 3];
    assert_true(alpha > 0.2649f - 0.001f && alpha < 0.2649f + 0.001f); /* 1 - 0.95^6 */
    splatted_close(&volume);
}

/* A light beside the eye: the middle of a ball faces it, the rim does not; classified before or
 * after. */
static void gradients_are_lit_before_and_after(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        VolumeSplatSetting setting = VOLUME_SPLAT_DEFAULTS;
        SplattedVolume volume;
        double middle = 0, rim = 0;
        setting.after = i;
        splatted_open("builtin:ball:40", "checkerboard", (double[3]){ 0, 0, 1 }, 2, &volume);
        volume.transfer =
            (Transfer){ .count = 2,
                        .stops = { { 120, { 1, 1, 1, 0 } }, { 135, { 1, 1, 1, 0.9 } } } };
        GpError error;
        assert_int_equal(volume_splats_classify(&volume.splats, &volume.transfer, &error), GP_OK);
        volume.view.camera.fovy = 0;
        volume.view.camera.height = 39; /* the ball's radius is 26 pixels */
        volume.view.lit = true;
        splatted_draw(&volume, &setting, drawn);
        const int centre = SPLATTED_SIDE / 2;
        for (int k = -2; k < 2; k++) {
            middle += (double)drawn[4 * (centre * SPLATTED_SIDE + centre + k)] / 4;
            rim += (double)drawn[4 * (centre * SPLATTED_SIDE + centre + 23 + k / 2)] / 4;
        }
        print_message("# middle %.2f, rim %.2f\n", middle, rim);
        assert_true(middle > 0.8 && rim < 0.75 * middle && rim > 0.2);
        splatted_close(&volume);
    }
}

static void bits_are_the_same_on_every_device(void **state)
{
    (void)state;
    static const double sides[] = { 2, 0.6, 0.2 };
    SplattedVolume volume;
    splatted_open("builtin:marschner-lobb:20", "marschner-lobb", oblique, 1, &volume);
    for (size_t i = 0; i < GP_COUNT(sides); i++) {
        VolumeSplatSetting setting = after();
        Frame frame = { .color = NULL };
        splatted_look(&volume, oblique, sides[i]);
        volume.view.lit = i > 0;
        setting.filter = (VoxelFilter)i;
        setting.cull = 4;
        splatted_build(&volume, &setting, &frame);
        run_everywhere(&frame);
        frame_free(&frame);
    }
    splatted_close(&volume);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(classified_voxels_blur_and_classified_sheets_do_not),
        cmocka_unit_test(a_slab_of_one_value_is_as_opaque_as_it_is_thick),
        cmocka_unit_test(gradients_are_lit_before_and_after),
        cmocka_unit_test(bits_are_the_same_on_every_device),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
