/* How splatted volumes fail, each failure beside its remedy. Popping is in test_volume_slabs.c,
 * blur in test_volume_after.c and test_volume_flat.c. */
#include "tests/support/splatted_volume.h"
#include "tests/support/unit.h"

#include <math.h>

enum { FLOATS = 4 * SPLATTED_SIDE * SPLATTED_SIDE };

static float drawn[FLOATS], truth[FLOATS];

static VolumeSplatSetting with_filter(VoxelFilter filter)
{
    VolumeSplatSetting setting = VOLUME_SPLAT_DEFAULTS;
    setting.filter = filter;
    return setting;
}

/* --- single filters --------------------------------------------------------------------------- */

/* Paper 003's figure 8: a checkerboard of three slices, seen from far and from near. out: by
 * filter */
static void draw_checkerboard(const char *board, double sides, double psnr[VOXEL_FILTERS])
{
    const VolumeSplatSetting whole = with_filter(VOXEL_EWA);
    SplattedVolume volume;
    splatted_open(board, "checkerboard", (double[3]){ 0, 0.8, 1 }, sides, &volume);
    volume.rays = sides > 1 ? 12 : 2; /* kernels are narrower than pixels */
    splatted_truth_of_method(&volume, &whole, truth);
    for (VoxelFilter filter = VOXEL_EWA; filter < VOXEL_FILTERS; filter++) {
        const VolumeSplatSetting setting = with_filter(filter);
        splatted_draw(&volume, &setting, drawn);
        psnr[filter] = splatted_psnr(drawn, truth);
    }
    splatted_close(&volume);
    print_message("# from %g sides: EWA %.1f, reconstruction %.1f, low-pass %.1f, adaptive %.1f, "
                  "bounded %.1f dB\n",
                  sides, psnr[VOXEL_EWA], psnr[VOXEL_RECONSTRUCTION], psnr[VOXEL_LOW_PASS],
                  psnr[VOXEL_ADAPTIVE], psnr[VOXEL_BOUNDED]);
}

/* Failure: without the low-pass filter far voxels alias. Remedy: both filters; or the choice. */
static void far_voxels_alias_without_the_low_pass_filter(void **state)
{
    (void)state;
    double psnr[VOXEL_FILTERS];
    draw_checkerboard("builtin:checkerboard:512", 2.5, psnr);
    assert_true(psnr[VOXEL_EWA] > psnr[VOXEL_RECONSTRUCTION] + 6);
    assert_true(psnr[VOXEL_ADAPTIVE] > psnr[VOXEL_EWA] - 0.5);
    assert_true(psnr[VOXEL_BOUNDED] > psnr[VOXEL_EWA] - 0.5);
}

/* Failure: the low-pass filter alone leaves near voxels as dots. Remedy: both, or the choice. */
static void near_voxels_are_dots_without_reconstruction(void **state)
{
    (void)state;
    double psnr[VOXEL_FILTERS];
    draw_checkerboard("builtin:checkerboard:128", 0.25, psnr);
    assert_true(psnr[VOXEL_EWA] > psnr[VOXEL_LOW_PASS] + 6);
    assert_true(psnr[VOXEL_ADAPTIVE] > psnr[VOXEL_EWA] - 0.5);
    assert_true(psnr[VOXEL_BOUNDED] > psnr[VOXEL_EWA] - 0.5);
}

/* --- sums of 8 bits --------------------------------------------------------------------------- */

/* A single voxel, whose light is spread over the pixels around. returns the sum of their alphas */
static double light_of_a_voxel(VoxelSums sums, double sides)
{
    VolumeSplatSetting setting = with_filter(VOXEL_EWA);
    Field field = { .size = { 9, 9, 9 }, .scale = { 1, 1, 1 }, .most = 255 };
    SplattedVolume volume;
    double sum = 0;
    field.value = gp_alloc(field_samples(&field), 1);
    assert_non_null(field.value);
    field.value[4 * 81 + 4 * 9 + 4] = 255;
    splatted_take(&field, "fog", (double[3]){ 0, 0, 1 }, sides, &volume);
    setting.sums = sums;
    splatted_draw(&volume, &setting, drawn);
    for (int i = 3; i < FLOATS; i += 4)
        sum += (double)drawn[i];
    splatted_close(&volume);
    return sum;
}

/* Failure: from far away 8 bits round what a voxel adds to nothing. Remedy: halves, which the
 * adaptive choice takes there; near by, bytes are enough. */
static void far_voxels_are_lost_in_8_bits(void **state)
{
    (void)state;
    const double bytes = light_of_a_voxel(VOXEL_BYTES, 60),
                 halves = light_of_a_voxel(VOXEL_HALVES, 60),
                 floats = light_of_a_voxel(VOXEL_FLOATS, 60),
                 chosen = light_of_a_voxel(VOXEL_BYTES_NEAR, 60);
    print_message("# far: bytes %.6f, halves %.6f, floats %.6f\n", bytes, halves, floats);
    assert_true(bytes == 0);
    assert_true(fabs(halves - floats) < 0.01 * floats && chosen == halves);
    assert_true(light_of_a_voxel(VOXEL_BYTES, 0.8) > 0.9 * light_of_a_voxel(VOXEL_FLOATS, 0.8));
    assert_true(light_of_a_voxel(VOXEL_BYTES, 0.8) == light_of_a_voxel(VOXEL_BYTES_NEAR, 0.8));
}

/* --- wide fields of view ---------------------------------------------------------------------- */

/* Failure: at the sides of a wide picture rays meet slices back to front, or hardly at all. Remedy:
 * sheets of equal depth, which all rays meet in one order. */
static void wide_views_see_slices_in_the_wrong_order(void **state)
{
    (void)state;
    VolumeSplatSetting printed = with_filter(VOXEL_EWA), remedy = with_filter(VOXEL_EWA);
    GpError error;
    SplattedVolume volume;
    splatted_open("builtin:marschner-lobb:32", "marschner-lobb", (double[3]){ 1, 0.1, 1.05 }, 0.95,
                  &volume);
    volume.transfer = (Transfer){ .count = 4,
                                  .stops = { { 100, { 1, 0, 0, 0 } },
                                             { 120, { 1, 0, 0, 0.6 } },
                                             { 140, { 0, 1, 0, 0.6 } },
                                             { 160, { 0, 0, 1, 0.6 } } } };
    assert_int_equal(volume_splats_classify(&volume.splats, &volume.transfer, &error), GP_OK);
    volume.view.camera.fovy = 125;
    for (int k = 0; k < 3; k++) /* along the volume's side */
        volume.view.camera.at[k] = volume.view.camera.eye[k] + (k == 1 ? 0 : k == 0 ? -1 : -0.98);
    volume.view.camera.eye[0] -= 14;
    volume.view.camera.at[0] -= 14;
    splatted_truth_of_method(&volume, &printed, truth);
    printed.thickness = remedy.thickness = 1;
    splatted_draw(&volume, &printed, drawn);
    const double slices = splatted_psnr(drawn, truth);
    remedy.sheets = SHEETS_IMAGE;
    splatted_draw(&volume, &remedy, drawn);
    const double slabs = splatted_psnr(drawn, truth);
    print_message("# slices %.1f dB, slabs %.1f dB\n", slices, slabs);
    assert_true(slabs > slices + 3);
    splatted_close(&volume);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_voxels_alias_without_the_low_pass_filter),
        cmocka_unit_test(near_voxels_are_dots_without_reconstruction),
        cmocka_unit_test(far_voxels_are_lost_in_8_bits),
        cmocka_unit_test(wide_views_see_slices_in_the_wrong_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
