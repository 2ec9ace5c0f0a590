/* Viewport: mapping, snapping, the implicit scissor. */
#include "pipeline/units/viewport.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

static GpScreenVertex transform(const GpViewport *viewport, float x, float y, float z, float w)
{
    GpScreenVertex screen = { 0 };
    assert_true(gp_viewport_position(viewport, (float[4]){ x, y, z, w }, &screen));
    return screen;
}

static void r01_d3d9_centres_are_the_viewport_moved_by_half_a_pixel(void **state)
{
    (void)state;
    GpViewport native = gp_viewport_resolve(&(GpViewport){ .width = 64, .height = 48 }, 64, 48);
    GpViewport d3d9 = gp_viewport_resolve(
        &(GpViewport){ .width = 64, .height = 48, .d3d9_centers = true }, 64, 48);
    Random random = { 1 };
    for (int i = 0; i < 1000; i++) {
        float x = random_float(&random, -1, 1), y = random_float(&random, -1, 1);
        native.x = native.y = 0.5f;
        GpScreenVertex a = transform(&native, x, y, 0.5f, 1), b = transform(&d3d9, x, y, 0.5f, 1);
        assert_int_equal(a.x, b.x);
        assert_int_equal(a.y, b.y);
    }
}

static void r02_snaps_to_256ths_ties_to_even(void **state)
{
    (void)state;
    for (int k = -2000; k <= 2000; k++) {
        float exact = (float)k / 256;
        assert_int_equal(gp_snap(exact), k);
        assert_int_equal(gp_snap(exact + 1.0f / 1024), k);
        assert_int_equal(gp_snap(exact - 1.0f / 1024), k);
        int even = k % 2 == 0 ? k : k + 1;
        assert_int_equal(gp_snap(exact + 1.0f / 512), even);
    }
    assert_int_equal(gp_snap(32767.99609375f), 32768 * 256 - 1);
    assert_int_equal(gp_snap(-32768), -32768 * 256);
}

static void r17_maps_the_corners_of_clip_space_to_those_of_the_viewport(void **state)
{
    (void)state;
    GpViewport v = {
        .x = 10, .y = 20, .width = 300, .height = 200, .min_depth = 0.25f, .max_depth = 0.75f
    };
    GpScreenVertex left_top = transform(&v, -1, 1, 0, 1), right_bottom = transform(&v, 2, -2, 2, 2);
    assert_int_equal(left_top.x, 10 * 256);
    assert_int_equal(left_top.y, 20 * 256);
    assert_true(left_top.z == 0.25f);
    assert_int_equal(right_bottom.x, 310 * 256);
    assert_int_equal(right_bottom.y, 220 * 256);
    assert_true(right_bottom.z == 0.75f && right_bottom.rw == 0.5f);
}

static void r17_within_half_a_step_of_the_exact_position(void **state)
{
    (void)state;
    Random random = { 17 };
    GpViewport v = gp_viewport_resolve(&(GpViewport){ 0 }, 1024, 768);
    for (int i = 0; i < 20000; i++) {
        float w = random_float(&random, 0.01f, 100);
        float x = random_float(&random, -w, w), y = random_float(&random, -w, w);
        GpScreenVertex s = transform(&v, x, y, 0, w);
        double exact_x = ((double)x / (double)w + 1) * 512,
               exact_y = (1 - (double)y / (double)w) * 384;
        /* half a step of snapping, and the binary32 roundings: under 2^-12 pixel at 1024 */
        assert_true(fabs(s.x / 256.0 - exact_x) <= 1.0 / 512 + 0x1p-12);
        assert_true(fabs(s.y / 256.0 - exact_y) <= 1.0 / 512 + 0x1p-12);
    }
}

static void a_depth_range_of_0_to_0_is_one_where_it_is_said(void **state)
{
    (void)state;
    GpViewport given = { .width = 0 };
    GpViewport v = gp_viewport_resolve(&given, 64, 64);
    assert_true(v.min_depth == 0 && v.max_depth == 1);
    given.has_depth_range = true;
    v = gp_viewport_resolve(&given, 64, 64);
    assert_true(v.min_depth == 0 && v.max_depth == 0);
    assert_true(transform(&v, 0, 0, 0.75f, 1).z == 0);
}

static void r14_fractional_edges_round_toward_negative_infinity(void **state)
{
    (void)state;
    GpViewport v = { .x = 1.75f, .y = 2.25f, .width = 3.5f, .height = 4 };
    GpRect r = gp_viewport_rect(&v, 100, 100);
    assert_int_equal(r.x0, 1);
    assert_int_equal(r.x1, 5); /* 5.25 */
    assert_int_equal(r.y0, 2);
    assert_int_equal(r.y1, 6); /* 6.25 */
    v = (GpViewport){ .x = -7.5f, .y = -0.25f, .width = 1000, .height = 1000 };
    r = gp_viewport_rect(&v, 100, 60);
    assert_true(r.x0 == 0 && r.y0 == 0 && r.x1 == 100 && r.y1 == 60);
}

static void zero_viewport_means_the_whole_target(void **state)
{
    (void)state;
    GpViewport v = gp_viewport_resolve(&(GpViewport){ 0 }, 123, 45);
    assert_true(v.width == 123 && v.height == 45 && v.min_depth == 0 && v.max_depth == 1);
    v = gp_viewport_resolve(&(GpViewport){ .height = 7 }, 123,
                            45); /* no width is not none at all */
    assert_true(v.width == 0 && v.height == 7);
}

static void positions_off_the_number_range_are_refused(void **state)
{
    (void)state;
    GpViewport v = gp_viewport_resolve(&(GpViewport){ 0 }, 64, 64);
    GpScreenVertex s;
    assert_false(gp_viewport_position(&v, (float[4]){ 1e9f, 0, 0, 1 }, &s));
    assert_false(gp_viewport_position(&v, (float[4]){ 0, -INFINITY, 0, 1 }, &s));
    assert_false(gp_viewport_position(&v, (float[4]){ NAN, 0, 0, 1 }, &s));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r01_d3d9_centres_are_the_viewport_moved_by_half_a_pixel),
        cmocka_unit_test(r02_snaps_to_256ths_ties_to_even),
        cmocka_unit_test(r17_maps_the_corners_of_clip_space_to_those_of_the_viewport),
        cmocka_unit_test(r17_within_half_a_step_of_the_exact_position),
        cmocka_unit_test(a_depth_range_of_0_to_0_is_one_where_it_is_said),
        cmocka_unit_test(r14_fractional_edges_round_toward_negative_infinity),
        cmocka_unit_test(zero_viewport_means_the_whole_target),
        cmocka_unit_test(positions_off_the_number_range_are_refused),
    };
    return cmocka_run_group_tests_name("viewport", tests, NULL, NULL);
}
