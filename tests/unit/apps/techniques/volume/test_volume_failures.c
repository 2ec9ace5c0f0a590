/* How pictures of volumes fail, each failure beside its remedy. Popping, 8-bit sums, blurred
 * surfaces and wide views have tests where splats are drawn. */
#include "apps/techniques/volume/report.h"
#include "apps/techniques/volume/technique.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

static void check(const TechniqueCase *rows, size_t count)
{
    GpError error;
    if (technique_cases_check(&volume_technique, rows, count, &error))
        fail_msg("%s", error.text);
}

#define BALL "builtin:ball:48"

static void what_splats_lose_is_found_again(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "splats are near the data", BALL, "--method splat", "decibels", 34, 60 },
        { "wide kernels blur it", BALL, "--method splat --deviation 2", "decibels", 10, 28 },
        { "the filter alone leaves gaps", BALL, "--method splat --filter lowpass --lowpass 0.3",
          "decibels", 5, 25 },
    };
    check(rows, GP_COUNT(rows));
}

/* --- figure 8 --------------------------------------------------------------------------------- */

/* Decibels of a checkerboard against what splats stand for, from above, larger than the picture by
 * so much. */
static double checkerboard_psnr(double zoom, VoxelFilter filter)
{
    VolumeOptions options = volume_option_defaults;
    options.method = VOLUME_SPLAT;
    options.splats.filter = filter;
    options.transfer = "checkerboard";
    options.orbit = (Orbit){ .azimuth = 30, .elevation = 55, .up = ORBIT_UP_Z, .zoom = zoom };
    const TechniqueInput input = {
        .path = "builtin:checkerboard:256", .width = 48, .height = 48, .setting = &options
    };
    GpError error;
    GpDevice *device;
    void *model;
    Frame frame = { .color = NULL };
    VolumeError off;
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, &error), GP_OK);
    if (volume_technique.open(&input, &model, &error) ||
        volume_technique.build(model, &options, device, &frame, &error) ||
        gp_device_run(device, &frame.list, &error) ||
        volume_error(model, &options, frame.color, 2, &off, &error))
        fail_msg("%s", error.text);
    frame_free(&frame);
    volume_technique.close(model);
    gp_device_destroy(&device);
    return off.psnr_method;
}

/* Smaller than a pixel, kernels alone fall between pixels; larger, the pixel's filter alone is
 * blocky. */
static void single_filters_alias_far_away_and_are_blocks_near(void **state)
{
    (void)state;
    double far[VOXEL_FILTERS], near[VOXEL_FILTERS];
    for (int filter = 0; filter < VOXEL_FILTERS; filter++) {
        far[filter] = checkerboard_psnr(1, (VoxelFilter)filter);
        near[filter] = checkerboard_psnr(14, (VoxelFilter)filter);
        print_message("# filter %d: %.1f dB far, %.1f dB near\n", filter, far[filter],
                      near[filter]);
    }
    assert_true(far[VOXEL_EWA] > 22 && far[VOXEL_RECONSTRUCTION] < far[VOXEL_EWA] - 5);
    assert_true(near[VOXEL_EWA] > 17 && near[VOXEL_LOW_PASS] < near[VOXEL_EWA] - 2);
    for (int filter = VOXEL_ADAPTIVE; filter < VOXEL_FILTERS; filter++)
        assert_true(far[filter] > far[VOXEL_EWA] - 0.5 && near[filter] > near[VOXEL_EWA] - 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_splats_lose_is_found_again),
        cmocka_unit_test(single_filters_alias_far_away_and_are_blocks_near),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
