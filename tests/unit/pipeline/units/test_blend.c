/* Blending: factors, operations, clamping, exactness of the 8-bit result. */
#include "pipeline/units/blend.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

static const float no_constant[4] = { 0, 0, 0, 0 };

/* Every factor once more, as Direct3D 9's table gives it. */
static double factor_oracle(int factor, int c, const float *s, const float *d, const float *k)
{
    double as = (double)s[3], ad = (double)d[3];
    switch (factor) {
    case GP_ZERO:
        return 0;
    case GP_ONE:
        return 1;
    case GP_SRC_COLOR:
        return (double)s[c];
    case GP_INV_SRC_COLOR:
        return 1 - (double)s[c];
    case GP_SRC_ALPHA:
        return as;
    case GP_INV_SRC_ALPHA:
        return 1 - as;
    case GP_DEST_ALPHA:
        return ad;
    case GP_INV_DEST_ALPHA:
        return 1 - ad;
    case GP_DEST_COLOR:
        return (double)d[c];
    case GP_INV_DEST_COLOR:
        return 1 - (double)d[c];
    case GP_SRC_ALPHA_SAT:
        return c == 3 ? 1 : fmin(as, 1 - ad);
    case GP_BLEND_CONSTANT:
        return (double)k[c];
    default:
        return 1 - (double)k[c];
    }
}

static double blend_oracle(int op, double s, double d, double fs, double fd)
{
    switch (op) {
    case GP_BLEND_ADD:
        return s * fs + d * fd;
    case GP_BLEND_SUBTRACT:
        return s * fs - d * fd;
    case GP_BLEND_REV_SUBTRACT:
        return d * fd - s * fs;
    case GP_BLEND_MIN:
        return fmin(s, d);
    default:
        return fmax(s, d);
    }
}

static void every_operation_with_every_pair_of_factors(void **state)
{
    (void)state;
    Random random = { 32 };
    for (int op = GP_BLEND_ADD; op <= GP_BLEND_MAX; op++)
        for (int src = 0; src < GP_BLEND_FACTORS; src++)
            for (int dst = 0; dst < GP_BLEND_FACTORS; dst++)
                for (int round = 0; round < 8; round++) {
                    float s[4], d[4], k[4], result[4];
                    for (int c = 0; c < 4; c++) {
                        s[c] = random_float(&random, 0, 1);
                        d[c] = random_float(&random, 0, 1);
                        k[c] = random_float(&random, 0, 1);
                    }
                    GpBlend blend = { .op = (GpBlendOp)op,
                                      .src = (GpBlendFactor)src,
                                      .dst = (GpBlendFactor)dst };
                    gp_blend(&blend, k, GP_A32B32G32R32F, s, d, result);
                    for (int c = 0; c < 4; c++) {
                        double exact = blend_oracle(op, (double)s[c], (double)d[c],
                                                    factor_oracle(src, c, s, d, k),
                                                    factor_oracle(dst, c, s, d, k));
                        assert_true(fabs((double)result[c] - exact) <= 0x1p-22);
                    }
                }
}

static void alpha_blends_by_itself_where_asked(void **state)
{
    (void)state;
    const float s[4] = { 0.5f, 0.5f, 0.5f, 0.5f }, d[4] = { 0.25f, 0.25f, 0.25f, 0.25f };
    float result[4];
    GpBlend blend = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE, .alpha_op = GP_BLEND_MIN };
    gp_blend(&blend, no_constant, GP_A8R8G8B8, s, d, result);
    assert_true(result[0] == 0.75f && result[1] == 0.75f && result[2] == 0.75f);
    assert_true(result[3] == 0.25f);
}

static void r30_min_and_max_prefer_the_number(void **state)
{
    (void)state;
    const float s[4] = { NAN, 1, NAN, 2 }, d[4] = { 3, NAN, NAN, 1 };
    float low[4], high[4];
    gp_blend(&(GpBlend){ .op = GP_BLEND_MIN }, no_constant, GP_A32B32G32R32F, s, d, low);
    gp_blend(&(GpBlend){ .op = GP_BLEND_MAX }, no_constant, GP_A32B32G32R32F, s, d, high);
    assert_true(low[0] == 3 && low[1] == 1 && isnan(low[2]) && low[3] == 1);
    assert_true(high[0] == 3 && high[1] == 1 && isnan(high[2]) && high[3] == 2);
}

static void r32_unorm_targets_clamp_what_comes_in(void **state)
{
    (void)state;
    const float s[4] = { 2, -1, NAN, 0.5f }, d[4] = { 0, 0, 0, 0 }, k[4] = { 9, 9, 9, 9 };
    float result[4];
    GpBlend blend = { .op = GP_BLEND_ADD, .src = GP_BLEND_CONSTANT, .dst = GP_ONE };
    gp_blend(&blend, k, GP_A8R8G8B8, s, d, result);
    assert_true(result[0] == 1 && result[1] == 0 && result[2] == 0 && result[3] == 0.5f);
    gp_blend(&blend, k, GP_A16B16G16R16F, s, d, result);
    assert_true(result[0] == 18 && result[1] == -9 && isnan(result[2]) && result[3] == 4.5f);
}

/* src-over of 8-bit values: the exact rational s*a/255 + d*(255-a)/255, rounded half up. */
static void r33_src_over_equals_exact_rational_rounding(void **state)
{
    (void)state;
    const char *all = getenv("GP_TEST_ALL_BLENDS"); /* `make check`: all 16,777,216 triples */
    int step = all ? 1 : 3;
    GpBlend blend = { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };
    for (int a = 0; a < 256; a++)
        for (int s = 0; s < 256; s += step)
            for (int d = (a + s) % step; d < 256; d += step) {
                float source[4] = { gp_float_from_unorm((uint32_t)s, 8), 0, 0,
                                    gp_float_from_unorm((uint32_t)a, 8) };
                float target[4] = { gp_float_from_unorm((uint32_t)d, 8), 0, 0, 0 };
                float result[4];
                gp_blend(&blend, no_constant, GP_A8R8G8B8, source, target, result);
                int exact = (2 * (s * a + d * (255 - a)) + 255) / 510;
                if ((int)gp_unorm_from_float(result[0], 8) != exact)
                    fail_msg("s %d d %d a %d: not %d", s, d, a, exact);
            }
}

static void r34_nan_and_infinity_propagate_through_factor_zero(void **state)
{
    (void)state;
    const float s[4] = { NAN, INFINITY, -0.0f, 1 }, d[4] = { 1, 1, -0.0f, NAN };
    float result[4];
    GpBlend blend = { .op = GP_BLEND_ADD, .src = GP_ZERO, .dst = GP_ONE };
    gp_blend(&blend, no_constant, GP_A32B32G32R32F, s, d, result);
    assert_true(isnan(result[0]) && isnan(result[1]) && isnan(result[3]));
    assert_true(gp_float_bits(result[2]) == 0x80000000u); /* -0 * 0 + -0 * 1 = -0 */
}

static void logic_works_on_the_stored_bits(void **state)
{
    (void)state;
    for (int op = GP_BLEND_LOGIC_AND; op <= GP_BLEND_LOGIC_XOR; op++)
        for (uint32_t s = 0; s < 256; s += 5)
            for (uint32_t d = 0; d < 256; d++) {
                float source[4], target[4], result[4];
                for (int c = 0; c < 4; c++) {
                    source[c] = gp_float_from_unorm(s, 8);
                    target[c] = gp_float_from_unorm(d, 8);
                }
                gp_blend(&(GpBlend){ .op = (GpBlendOp)op }, no_constant, GP_R8, source, target,
                         result);
                uint32_t exact = op == GP_BLEND_LOGIC_AND  ? (s & d)
                                 : op == GP_BLEND_LOGIC_OR ? (s | d)
                                                           : (s ^ d);
                assert_int_equal(gp_unorm_from_float(result[0], 8), exact);
                assert_int_equal(gp_unorm_from_float(result[3], 8), exact);
            }
}

static void off_replaces(void **state)
{
    (void)state;
    const float s[4] = { 0.1f, 0.2f, 0.3f, 0.4f }, d[4] = { 1, 1, 1, 1 };
    float result[4];
    gp_blend(&(GpBlend){ .op = GP_BLEND_OFF }, no_constant, GP_A32B32G32R32F, s, d, result);
    assert_memory_equal(result, s, sizeof s);
    assert_false(gp_blend_reads_target(&(GpBlend){ .op = GP_BLEND_OFF }));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_operation_with_every_pair_of_factors),
        cmocka_unit_test(alpha_blends_by_itself_where_asked),
        cmocka_unit_test(r30_min_and_max_prefer_the_number),
        cmocka_unit_test(r32_unorm_targets_clamp_what_comes_in),
        cmocka_unit_test(r33_src_over_equals_exact_rational_rounding),
        cmocka_unit_test(r34_nan_and_infinity_propagate_through_factor_zero),
        cmocka_unit_test(logic_works_on_the_stored_bits),
        cmocka_unit_test(off_replaces),
    };
    return cmocka_run_group_tests_name("blend", tests, NULL, NULL);
}
