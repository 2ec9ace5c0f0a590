/* The picture comparison: figures worked out by hand, and a brute-force SSIM as oracle. */
#include "apps/compare/compare.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { SIDE = 70 }; /* two tiles a side, the second one narrow */

typedef struct Pair {
    float a[SIDE * SIDE * 4], b[SIDE * SIDE * 4];
    Picture pa, pb;
} Pair;

static Pair pair;

/* Two equal pictures of a fixed pattern in [0, 1). */
static void fill_pair(uint32_t width, uint32_t height, int channels)
{
    Random random = { 12345 };
    for (size_t i = 0; i < GP_COUNT(pair.a); i++)
        pair.a[i] = random_float(&random, 0, 1);
    memcpy(pair.b, pair.a, sizeof pair.a);
    pair.pa = (Picture){ width, height, channels, pair.a };
    pair.pb = (Picture){ width, height, channels, pair.b };
}

static float *b_at(uint32_t x, uint32_t y, int channel)
{
    return &pair.b[((size_t)y * pair.pb.width + x) * (size_t)pair.pb.channels + (size_t)channel];
}

static CompareReport compare(const CompareLimits *limits)
{
    CompareReport report;
    compare_pictures(&pair.pa, &pair.pb, limits, &report);
    return report;
}

static const CompareLimits no_limits = { -1, -1, -1, -1, -1, -1 };

/* So much, of so many per cent; of any; negative: no limit. */
static CompareReport compare_fail(double fail, double percent, double hard)
{
    CompareLimits limits = no_limits;
    limits.fail = fail;
    limits.fail_percent = percent;
    limits.hard_fail = hard;
    return compare(&limits);
}

/* The same of warnings, where nothing below 1 fails. */
static CompareReport compare_warn(double warn, double percent, double hard)
{
    CompareLimits limits = no_limits;
    limits.fail = 1;
    limits.warn = warn;
    limits.warn_percent = percent;
    limits.hard_warn = hard;
    return compare(&limits);
}

static void same_bits_differ_nowhere(void **state)
{
    (void)state;
    fill_pair(SIDE, SIDE, 4);
    CompareReport report = compare(&no_limits);
    assert_true(report.same);
    assert_false(report.failed);
    assert_int_equal(report.differing, 0);
    assert_int_equal(report.pixels, SIDE * SIDE);
    assert_true(report.max == 0 && report.mean == 0 && report.rmse == 0);
    assert_true(isinf(report.psnr));
    assert_true(fabs(report.ssim - 1) < 1e-12);
}

static void two_changed_pixels_give_the_metrics_worked_out_by_hand(void **state)
{
    (void)state;
    fill_pair(SIDE, SIDE, 4);
    memset(pair.a, 0, sizeof pair.a);
    memset(pair.b, 0, sizeof pair.b);
    *b_at(69, 3, 0) = 0.25f;
    *b_at(10, 66, 1) = 0.5f;
    *b_at(10, 66, 3) = 0.5f;
    CompareReport report = compare(&no_limits);
    double count = SIDE * SIDE * 4;
    assert_false(report.same);
    assert_true(report.failed);
    assert_int_equal(report.differing, 2);
    assert_int_equal(report.first_x, 69);
    assert_int_equal(report.first_y, 3);
    assert_int_equal(report.tile_x, 0);
    assert_int_equal(report.tile_y, 64);
    assert_int_equal(report.tile_differing, 1);
    assert_true(report.max == 0.5);
    assert_true(report.mean == 1.25 / count);
    assert_true(report.rmse == sqrt(0.5625 / count));
    assert_true(fabs(report.psnr - 10 * log10(count / 0.5625)) < 1e-9);
}

static void negative_zero_differs_in_bits_only(void **state)
{
    (void)state;
    fill_pair(SIDE, SIDE, 1);
    pair.a[0] = 0.0f;
    pair.b[0] = -0.0f;
    CompareReport report = compare(&no_limits);
    assert_false(report.same);
    assert_true(report.failed);
    assert_int_equal(report.differing, 1);
    assert_true(report.max == 0);
    assert_false(compare_fail(1e-6, -1, -1).failed);
}

static void equal_nans_are_the_same_and_a_nan_against_a_number_is_infinitely_far(void **state)
{
    (void)state;
    fill_pair(SIDE, SIDE, 3);
    pair.a[3] = pair.b[3] = gp_bits_float(0x7fc00000u);
    assert_true(compare(&no_limits).same);
    pair.b[3] = 1;
    CompareReport report = compare_fail(1e30, -1, -1);
    assert_true(report.failed);
    assert_true(isinf(report.max));
    assert_int_equal(report.first_x, 1);
}

static void tolerances_work_as_idiff_defines_them(void **state)
{
    (void)state;
    fill_pair(10, 10, 1);
    memset(pair.a, 0, sizeof pair.a);
    memset(pair.b, 0, sizeof pair.b);
    for (uint32_t i = 0; i < 5; i++)
        *b_at(i, 0, 0) = 0.25f; /* five of a hundred pixels */

    assert_true(compare_fail(0.125, -1, -1).failed);
    assert_int_equal(compare_fail(0.125, -1, -1).failing, 5);
    assert_false(compare_fail(0.25, -1, -1).failed); /* more than, not as much */
    assert_false(compare_fail(0.125, 5, -1).failed);
    assert_true(compare_fail(0.125, 4.9, -1).failed);
    assert_false(compare_fail(-1, 5, -1).failed);
    assert_true(compare_fail(-1, 5, 0.2).failed);
    assert_false(compare_fail(-1, 5, 0.25).failed);

    /* 0 is a limit like any other */
    assert_true(compare_fail(1, -1, 0).failed);
    assert_true(compare_fail(0, 4.9, -1).failed);
    assert_false(compare_fail(0, 5, -1).failed);

    assert_false(compare_fail(1, -1, -1).warned);
    assert_true(compare_warn(0.125, -1, -1).warned);
    assert_false(compare_warn(0.125, 5, -1).warned);
    assert_true(compare_warn(-1, -1, 0.125).warned);
    assert_true(compare_warn(-1, -1, 0).warned);
    assert_true(compare_warn(0, -1, -1).warned);
    assert_false(compare_warn(0, 5, -1).warned);
    assert_false(compare_warn(-1, 0, -1).warned);
}

/* SSIM of the definition: every window by itself, weights by their two-dimensional formula, central
 * moments instead of raw ones. */
static double brute_ssim(void)
{
    double total = 0;
    int windows = 0;
    for (uint32_t y = 0; y + 11 <= pair.pa.height; y++) {
        for (uint32_t x = 0; x + 11 <= pair.pa.width; x++, windows++) {
            double sum = 0, ma = 0, mb = 0, vaa = 0, vbb = 0, vab = 0;
            for (int pass = 0; pass < 2; pass++) {
                for (uint32_t k = 0; k < 121; k++) {
                    double dx = (double)(k % 11) - 5, dy = (double)(k / 11) - 5;
                    double w = exp(-(dx * dx + dy * dy) / 4.5);
                    size_t i = (size_t)(y + k / 11) * pair.pa.width + x + k % 11;
                    double va = (double)pair.a[i], vb = (double)pair.b[i];
                    if (pass == 0) {
                        sum += w;
                        ma += w * va;
                        mb += w * vb;
                    } else {
                        vaa += w / sum * (va - ma) * (va - ma);
                        vbb += w / sum * (vb - mb) * (vb - mb);
                        vab += w / sum * (va - ma) * (vb - mb);
                    }
                }
                ma /= pass == 0 ? sum : 1;
                mb /= pass == 0 ? sum : 1;
            }
            total += (2 * ma * mb + 0.0001) * (2 * vab + 0.0009) /
                     ((ma * ma + mb * mb + 0.0001) * (vaa + vbb + 0.0009));
        }
    }
    return total / windows;
}

static void ssim_agrees_with_every_window_computed_alone(void **state)
{
    (void)state;
    fill_pair(40, 31, 1);
    for (size_t i = 0; i < 40 * 31; i += 3)
        pair.b[i] = pair.b[i] * 0.75f + 0.1f;
    double ssim = compare(&no_limits).ssim;
    assert_true(ssim > 0 && ssim < 0.99);
    assert_true(fabs(ssim - brute_ssim()) < 1e-9);
    fill_pair(40, 31, 1);
    for (size_t x = 0; x < 40; x++) /* rows above and below are the same */
        pair.b[15 * 40 + x] += 0.25f;
    assert_true(fabs(compare(&no_limits).ssim - brute_ssim()) < 1e-9);
}

static void ssim_sees_luminance_and_needs_a_whole_window(void **state)
{
    (void)state;
    fill_pair(20, 20, 4);
    *b_at(7, 7, 3) += 0.5f; /* alpha is no luminance */
    assert_true(fabs(compare(&no_limits).ssim - 1) < 1e-12);
    *b_at(7, 7, 1) += 0.5f;
    assert_true(compare(&no_limits).ssim < 0.9999);
    fill_pair(10, 20, 4);
    assert_true(isnan(compare(&no_limits).ssim));
}

static void difference_picture_is_absolute_scaled_and_opaque(void **state)
{
    (void)state;
    fill_pair(2, 1, 4);
    static float a[8] = { 0.5f, 0, 0, 1, 0, 0.25f, 0, 0 };
    static float b[8] = { 0.25f, 0, 0, 0, 0, 0.5f, 0, 0 };
    static const float expected[8] = { 1, 0, 0, 1, 0, 1, 0, 1 };
    float values[8];
    Picture pa = { 2, 1, 4, a }, pb = { 2, 1, 4, b };
    compare_difference(&pa, &pb, 4, values);
    assert_memory_equal(values, expected, sizeof expected);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_bits_differ_nowhere),
        cmocka_unit_test(two_changed_pixels_give_the_metrics_worked_out_by_hand),
        cmocka_unit_test(negative_zero_differs_in_bits_only),
        cmocka_unit_test(equal_nans_are_the_same_and_a_nan_against_a_number_is_infinitely_far),
        cmocka_unit_test(tolerances_work_as_idiff_defines_them),
        cmocka_unit_test(ssim_agrees_with_every_window_computed_alone),
        cmocka_unit_test(ssim_sees_luminance_and_needs_a_whole_window),
        cmocka_unit_test(difference_picture_is_absolute_scaled_and_opaque),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
