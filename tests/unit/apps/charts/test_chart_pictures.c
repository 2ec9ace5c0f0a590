/* Pictures of a chart's best settings, and where they are wrong. */
#include "apps/charts/chart_difference.h"
#include "apps/charts/chart_run.h"
#include "apps/techniques/fragments/technique.h"
#include "apps/techniques/voxel/technique.h"
#include "tests/support/folder.h"

#include <math.h>

/* --- a difference ----------------------------------------------------------------------------- */

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

/* One pixel is off, above or below: one in the left half, sixteen in the right one, and these are
 * the same, however small the difference is. */
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

/* A picture of halves, from black to more than white, has the greys that it has in bytes. */
static void pictures_of_every_format_are_seen_in_pale_grey(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_A16B16G16R16F, GP_A32B32G32R32F };
    static const float values[] = { 0, 0.2f, 1, 3 };
    const float off[WIDTH * HEIGHT] = { 0 };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        GpSurface *picture;
        Picture made = { .values = NULL };
        GpError error = { "" };
        const GpSurfaceDesc desc = { .format = formats[f], .width = WIDTH, .height = HEIGHT };
        const size_t bytes = gp_format_info(formats[f])->bytes;
        assert_int_equal(gp_surface_create(&desc, &picture, &error), GP_OK);
        for (uint32_t y = 0; y < HEIGHT; y++)
            for (uint32_t x = 0; x < WIDTH; x++) {
                const float value = values[x % GP_COUNT(values)];
                gp_texel_store(formats[f], gp_surface_texel(&picture->level[0], bytes, x, y),
                               (float[4]){ value, value, value, 1 }, 0);
            }
        assert_int_equal(chart_difference(picture, off, &made, &error), GP_OK);
        for (uint32_t x = 0; x < WIDTH; x++) {
            const float value = fminf(values[x % GP_COUNT(values)], 1);
            const float *grey = made.values + 3 * (size_t)(5 * 2 * WIDTH + x);
            assert_true(x < 2 || x > WIDTH - 3 || fabsf(grey[0] - 0.55f - 0.4f * value) < 1e-3f ||
                        grey[0] == 0); /* the frame */
        }
        gp_surface_destroy(&picture);
        picture_free(&made);
    }
}

/* --- what is beaten --------------------------------------------------------------------------- */

static const ChartPoint *find_point(const Chart *chart, const char *options)
{
    for (uint32_t i = 0; i < chart->count; i++)
        if (strcmp(chart->points[i].options, options) == 0)
            return &chart->points[i];
    fail_msg("no point %s", options);
    return NULL;
}

/* The k-buffer of 32 is exact, and takes longer than sorting; the worst of it has a picture, as the
 * only one of the average has. */
static void methods_that_are_beaten_show_where_they_are_wrong(void **state)
{
    (void)state;
    static const TechniqueSweep sweep[] = { { "sorted", "--method sorted" },
                                            { "k-buffer", "--method kbuffer --kept 32|2|4" },
                                            { "peeling", "--method dp" },
                                            { "weighted", "--method weighted" },
                                            { .method = NULL } };
    Experiment experiment = fragment_technique.experiments[0];
    experiment.sweep = sweep;
    Chart chart = { .points = NULL };
    GpError error = { "" };
    ChartJob job = { .technique = &fragment_technique,
                     .experiment = &experiment,
                     .scene = "builtin:knot",
                     .width = 96,
                     .height = 96,
                     .folder = folder,
                     .name = "a" };
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &job.device, &error), GP_OK);
    if (chart_run(&job, &chart, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&job.device);
    const ChartPoint *two = find_point(&chart, "--method kbuffer --kept 2");
    const ChartPoint *weighted = find_point(&chart, "--method weighted");
    assert_true(two->measured.error >
                find_point(&chart, "--method kbuffer --kept 4")->measured.error);
    assert_true(two->picture[0] && weighted->picture[0]);
    assert_true(strcmp(two->picture, weighted->picture) != 0);
    for (uint32_t i = 0; i < chart.count; i++) {
        const ChartPoint *point = &chart.points[i];
        const bool shown = point->best || point == two || point == weighted;
        assert_true((point->picture[0] != '\0') == shown);
        assert_true(!shown || access(in_folder(point->picture), R_OK) == 0);
    }
    chart_free(&chart);
}

/* --- volumes ---------------------------------------------------------------------------------- */

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
        cmocka_unit_test(pictures_of_every_format_are_seen_in_pale_grey),
        IN_FOLDER(methods_that_are_beaten_show_where_they_are_wrong),
        IN_FOLDER(exact_voxels_differ_nowhere_and_others_where_they_are_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
