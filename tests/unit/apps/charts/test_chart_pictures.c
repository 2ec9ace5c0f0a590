/* Pictures of a chart's best settings, and where they are wrong. */
#include "apps/charts/chart_difference.h"
#include "apps/charts/chart_run.h"
#include "apps/techniques/voxel/technique.h"
#include "tests/support/folder.h"

#include <math.h>

/* --- a difference ------------------------------------------------------------------------------- */

enum { WIDTH = 64, HEIGHT = 32 };

/* Of a picture that is all white. */
static Picture make_difference(const float *off)
{
    GpSurface *white;
    Picture made = { .values = NULL };
    GpError error = { "" };
    assert_int_equal(
        gp_surface_create(
            &(GpSurfaceDesc){ .format = GP_A8R8G8B8, .width = WIDTH, .height = HEIGHT }, &white,
            &error),
        GP_OK);
    memset(white->level[0].texels, 255, (size_t)4 * WIDTH * HEIGHT);
    assert_int_equal(chart_difference(white, off, &made, &error), GP_OK);
    gp_surface_destroy(&white);
    assert_int_equal(made.width, 2 * WIDTH);
    assert_int_equal(made.height, HEIGHT);
    assert_int_equal(made.channels, 3);
    return made;
}

static bool has_color(const float *pixel)
{
    return pixel[0] != pixel[1] || pixel[1] != pixel[2];
}

static bool is_orange(const float *pixel)
{
    return pixel[0] > pixel[1] && pixel[1] > pixel[2];
}

/* One pixel is off, above or below: one in the left half, sixteen in the right one, and these are the
 * same, however small the difference is. */
static void a_wrong_pixel_is_seen_and_four_times_as_large_beside(void **state)
{
    (void)state;
    static const float amounts[] = { 1, -1, 1e-3f, -1e-3f };
    for (size_t i = 0; i < GP_COUNT(amounts); i++) {
        float off[WIDTH * HEIGHT] = { 0 };
        int left = 0, right = 0;
        off[WIDTH * 21 + 50] = amounts[i];
        Picture made = make_difference(off);
        for (uint32_t k = 0; k < made.width * made.height; k++) {
            const float *pixel = made.values + 3 * k;
            if (!has_color(pixel))
                continue;
            *(k % made.width < WIDTH ? &left : &right) += 1;
            assert_int_equal(is_orange(pixel), amounts[i] > 0);
        }
        assert_int_equal(left, 1);
        assert_int_equal(right, 16);
        assert_true(has_color(made.values + 3 * (made.width * 21 + 50)));
        picture_free(&made);
    }
}

static void where_nothing_differs_nothing_has_colour(void **state)
{
    (void)state;
    const float off[WIDTH * HEIGHT] = { 0 };
    Picture made = make_difference(off);
    for (uint32_t k = 0; k < made.width * made.height; k++)
        assert_false(has_color(made.values + 3 * k));
    picture_free(&made);
}

/* --- volumes ------------------------------------------------------------------------------------ */

/* How many pixels have colour in the difference of a chart of one setting. */
static int wrong_pixels(const char *options)
{
    const TechniqueSweep sweep[] = { { "one", options }, { .method = NULL } };
    Experiment experiment = voxel_technique.experiments[0];
    experiment.sweep = sweep;
    Chart chart = { .points = NULL };
    GpError error = { "" };
    ChartJob job = { .technique = &voxel_technique,
                     .experiment = &experiment,
                     .scene = "builtin:knot",
                     .folder = folder,
                     .name = "a" };
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &job.device, &error), GP_OK);
    if (chart_run(&job, &chart, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&job.device);
    assert_int_equal(chart.count, 1);
    assert_string_equal(chart.points[0].picture, "a_1.png");
    chart_free(&chart);

    Picture shown, difference;
    int wrong = 0;
    assert_int_equal(picture_read(in_folder("a_1.png"), &shown, &error), GP_OK);
    assert_int_equal(shown.width, 512); /* a picture, not a sheet of bits */
    assert_int_equal(picture_read(in_folder("a_1_difference.png"), &difference, &error), GP_OK);
    assert_int_equal(difference.width, 2 * shown.width);
    for (size_t i = 0; i < (size_t)difference.width * difference.height; i++)
        wrong += has_color(difference.values + (size_t)difference.channels * i);
    picture_free(&shown);
    picture_free(&difference);
    return wrong;
}

static void exact_voxels_differ_nowhere_and_others_where_they_are_wrong(void **state)
{
    (void)state;
    assert_int_equal(wrong_pixels("--method conservative --size 16"), 0);
    assert_true(wrong_pixels("--method sheets --axes 1 --blend or --size 16") > 100);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wrong_pixel_is_seen_and_four_times_as_large_beside),
        cmocka_unit_test(where_nothing_differs_nothing_has_colour),
        IN_FOLDER(exact_voxels_differ_nowhere_and_others_where_they_are_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
