/* The arithmetic unit's functions: against the C library in double, at every edge, and the same
 * bits in every build. */
#include "tests/kernel/detmath_oracle.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <xxhash.h>

static bool same_bits_or_both_nan(float a, float b)
{
    return gp_float_bits(a) == gp_float_bits(b) || (isnan(a) && isnan(b));
}

static float one(flt (*function)(flt), float x)
{
    return function(flt_set(x))[GP_LANES - 1];
}

static float one_pow(float x, float y)
{
    return math_pow(flt_set(x), flt_set(y))[GP_LANES - 1];
}

/* Every float whose bits are a multiple of a prime: all exponents and signs, changing low bits. */
static double worst_of_stride(const DetmathFunction *function, uint32_t stride, float *worst_x)
{
    double worst = 0.0;
    uint64_t step = (uint64_t)stride * GP_LANES;
    for (uint64_t bits = 0; bits < UINT64_C(1) << 32; bits += step) {
        flt x;
        for (int lane = 0; lane < GP_LANES; lane++)
            x[lane] = gp_bits_float((uint32_t)bits + stride * (uint32_t)lane);
        flt result = function->lanes(x);
        for (int lane = 0; lane < GP_LANES; lane++) {
            double error = detmath_error(function, x[lane], result[lane]);
            if (error > worst) {
                worst = error;
                *worst_x = x[lane];
            }
        }
    }
    return worst;
}

static void assert_within_bounds(const char *const *names, size_t count)
{
    for (size_t n = 0; n < count; n++) {
        const DetmathFunction *function = NULL;
        for (size_t i = 0; i < GP_COUNT(detmath_functions); i++)
            if (strcmp(detmath_functions[i].name, names[n]) == 0)
                function = &detmath_functions[i];
        assert_non_null(function);
        float worst_x = 0.0f;
        double worst = worst_of_stride(function, 1009, &worst_x);
        if (worst > function->ulps)
            fail_msg("%s: %.4f ulp at %a", names[n], worst, (double)worst_x);
    }
}

/* Processors' estimates miss the quotient for nearly every value in [1, 2), each maker's by other
 * bits. */
static void r51_rcp_and_rsq_are_divisions_not_estimates(void **state)
{
    (void)state;
    for (uint32_t bits = gp_float_bits(1.0f); bits < gp_float_bits(4.0f); bits += 97) {
        float x = gp_bits_float(bits);
        /* binary64 has more than twice the bits: rounding twice is rounding once */
        float root = (float)sqrt((double)x);
        assert_true(math_rcp(flt_set(x))[0] == (float)(1.0 / (double)x));
        assert_true(math_rsq(flt_set(x))[0] == (float)(1.0 / (double)root));
    }
}

/* --- accuracy --------------------------------------------------------------------------------- */

static void r50_floor_frc_and_rcp_are_exact(void **state)
{
    (void)state;
    static const char *const names[] = { "floor", "frc", "rcp" };
    assert_within_bounds(names, GP_COUNT(names));
}

static void r52_rsq_exp2_log2_sin_cos_are_within_two_ulp(void **state)
{
    (void)state;
    static const char *const names[] = { "rsq", "exp2", "log2", "log2_d3d", "sin", "cos" };
    assert_within_bounds(names, GP_COUNT(names));
}

/* Asserts 15 bits of pow(x, y) where the true result is a normal float; tells whether it is. */
static bool pow_is_accurate(float x, float y)
{
    double truth = pow(fabs((double)x), (double)y);
    if (!(truth >= (double)FLT_MIN && truth <= (double)FLT_MAX))
        return false;
    double error = fabs((double)one_pow(x, y) - truth) / truth;
    if (!(error <= 0x1p-15))
        fail_msg("pow(%a, %a): relative error %g", (double)x, (double)y, error);
    return true;
}

static void r52_pow_of_random_pairs_has_15_bits(void **state)
{
    (void)state;
    Random random = { 1 };
    uint32_t normal = 0;
    for (uint32_t i = 0; i < 600000; i++) {
        uint32_t bits = (uint32_t)random_bits(&random) & 0x7fffffff;
        float scale = gp_bits_float((bits & 15) << 23 | 0x38000000); /* 2^-15 ... 1 */
        float x = i % 3 == 0   ? gp_bits_float(bits)
                  : i % 3 == 1 ? (float)(bits >> 7) * 0x1p-24f
                               : 1.0f + ((float)(bits >> 7) - 0x1p23f) * 0x1p-24f * scale;
        /* The exponent that takes x anywhere in the range of floats. */
        double target = (double)(random_bits(&random) >> 11) * 0x1p-53 * 254.0 - 126.0;
        float y = (float)(target / log2((double)x));
        if (isfinite(x) && isfinite(y))
            normal += pow_is_accurate(x, y);
    }
    assert_true(normal > 550000);
}

static void r52_pow_of_structured_pairs_has_15_bits(void **state)
{
    (void)state;
    static const float exponents[] = { 1.0f,        2.0f,  3.0f,   5.0f,    8.0f,        16.0f,
                                       32.0f,       64.0f, 127.0f, 0.5f,    1.0f / 3.0f, 0.25f,
                                       1.0f / 2.2f, 2.2f,  2.4f,   0x1p-20f };
    uint32_t normal = 0;
    for (uint32_t i = 1; i <= 4096; i++)
        for (size_t e = 0; e < GP_COUNT(exponents); e++) {
            float cosine = (float)i / 4096.0f;
            normal += pow_is_accurate(cosine, exponents[e]);
            normal += pow_is_accurate(-cosine, -exponents[e]);
            normal += pow_is_accurate(gp_bits_float(i), exponents[e]); /* denormals */
            normal += pow_is_accurate(gp_bits_float(0x7f800000 - i), -exponents[e]);
        }
    assert_true(normal > 150000);
}

/* --- exact values and edges ------------------------------------------------------------------- */

static void r52_exp2_and_log2_are_exact_at_powers_of_two(void **state)
{
    (void)state;
    for (int exponent = -149; exponent <= 127; exponent++) {
        float power = ldexpf(1.0f, exponent);
        assert_true(one(lanes_exp2, (float)exponent) == power);
        assert_true(one(lanes_log2, power) == (float)exponent);
        assert_true(one(lanes_log2_d3d, -power) == (float)exponent);
    }
}

static void r29_exp2_underflows_gradually(void **state)
{
    (void)state;
    float previous = 1.0f;
    for (int i = 0; i <= 26 * 64; i++) {
        float x = -125.0f - (float)i / 64.0f;
        float result = one(lanes_exp2, x);
        double truth = exp2((double)x);
        assert_true(fabs((double)result - truth) <= 0x1p-150 + truth * 0x1p-23);
        assert_true(result <= previous);
        previous = result;
    }
    assert_true(one(lanes_exp2, -149.99998f) == 0x1p-149f);
    assert_true(previous == 0.0f);
}

static void r52_sin_is_odd_cos_is_even_and_both_stay_in_range(void **state)
{
    (void)state;
    uint32_t stride = 10007;
    for (uint64_t bits = 0; bits < 0x7f800000; bits += stride) {
        float x = gp_bits_float((uint32_t)bits);
        float sine = one(lanes_sin, x);
        float cosine = one(lanes_cos, x);
        assert_true(same_bits_or_both_nan(one(lanes_sin, -x), -sine));
        assert_true(same_bits_or_both_nan(one(lanes_cos, -x), cosine));
        assert_true(fabsf(sine) <= 1.0f && fabsf(cosine) <= 1.0f);
        if (x <= 0x1p22f && x > 8192.0f) {
            assert_true(fabs((double)sine - sin((double)x)) <= (double)x * 0x1p-22);
            assert_true(fabs((double)cosine - cos((double)x)) <= (double)x * 0x1p-22);
        }
    }
}

typedef struct Edge {
    flt (*function)(flt);
    float x, result;
} Edge;

#define TINY 0x1p-149f /* the smallest denormal */
#define INF  INFINITY

/* One step below -126 is 2^-17, which takes ln(2) 2^-17 2^23 = 44 denormals from FLT_MIN. */
/* clang-format off */
static const Edge edges[] = {
    { lanes_floor, 0.0f, 0.0f }, { lanes_floor, -0.0f, -0.0f }, { lanes_floor, INF, INF },
    { lanes_floor, -INF, -INF }, { lanes_floor, NAN, NAN }, { lanes_floor, TINY, 0.0f },
    { lanes_floor, -TINY, -1.0f }, { lanes_floor, -2.5f, -3.0f }, { lanes_floor, -3.0f, -3.0f },
    { lanes_floor, 0x1.fffffep-1f, 0.0f }, { lanes_floor, 8388607.5f, 8388607.0f },
    { lanes_floor, -8388607.5f, -8388608.0f }, { lanes_floor, FLT_MAX, FLT_MAX },

    { lanes_frc, 0.0f, 0.0f }, { lanes_frc, -0.0f, 0.0f }, { lanes_frc, INF, NAN },
    { lanes_frc, -INF, NAN }, { lanes_frc, NAN, NAN }, { lanes_frc, TINY, TINY },
    { lanes_frc, -TINY, 1.0f }, { lanes_frc, -1.25f, 0.75f }, { lanes_frc, FLT_MAX, 0.0f },
    { lanes_frc, -0x1p-25f, 1.0f }, { lanes_frc, -0x1p-24f, 0x1.fffffep-1f },

    { lanes_rcp, 0.0f, INF }, { lanes_rcp, -0.0f, -INF }, { lanes_rcp, INF, 0.0f },
    { lanes_rcp, -INF, -0.0f }, { lanes_rcp, NAN, NAN }, { lanes_rcp, TINY, INF },
    { lanes_rcp, 0x1p-128f, INF }, { lanes_rcp, 0x1p127f, 0x1p-127f },
    { lanes_rcp, -4.0f, -0.25f },

    { lanes_rsq, 0.0f, INF }, { lanes_rsq, -0.0f, -INF }, { lanes_rsq, INF, 0.0f },
    { lanes_rsq, -1.0f, NAN }, { lanes_rsq, -INF, NAN }, { lanes_rsq, NAN, NAN },
    { lanes_rsq, -TINY, NAN }, { lanes_rsq, 0x1p-148f, 0x1p74f }, { lanes_rsq, 16.0f, 0.25f },

    { lanes_exp2, 0.0f, 1.0f }, { lanes_exp2, -0.0f, 1.0f }, { lanes_exp2, INF, INF },
    { lanes_exp2, -INF, 0.0f }, { lanes_exp2, NAN, NAN }, { lanes_exp2, -NAN, NAN },
    { lanes_exp2, TINY, 1.0f }, { lanes_exp2, -TINY, 1.0f }, { lanes_exp2, 128.0f, INF },
    { lanes_exp2, FLT_MAX, INF }, { lanes_exp2, -FLT_MAX, 0.0f }, { lanes_exp2, -150.0f, 0.0f },
    { lanes_exp2, -149.0f, TINY }, { lanes_exp2, -126.0f, FLT_MIN },
    { lanes_exp2, -0x1.f80002p6f, FLT_MIN - TINY * 44.0f },

    { lanes_log2, 1.0f, 0.0f }, { lanes_log2, 0.0f, -INF }, { lanes_log2, -0.0f, -INF },
    { lanes_log2, INF, INF }, { lanes_log2, -INF, NAN }, { lanes_log2, -1.0f, NAN },
    { lanes_log2, -TINY, NAN }, { lanes_log2, NAN, NAN }, { lanes_log2, -NAN, NAN },
    { lanes_log2, TINY, -149.0f }, { lanes_log2, FLT_MIN, -126.0f },
    { lanes_log2, FLT_MAX, 128.0f },

    { lanes_log2_d3d, 1.0f, 0.0f }, { lanes_log2_d3d, 0.0f, -FLT_MAX },
    { lanes_log2_d3d, -0.0f, -FLT_MAX }, { lanes_log2_d3d, INF, INF },
    { lanes_log2_d3d, -INF, INF }, { lanes_log2_d3d, -1.0f, 0.0f }, { lanes_log2_d3d, NAN, NAN },
    { lanes_log2_d3d, -TINY, -149.0f },

    { lanes_sin, 0.0f, 0.0f }, { lanes_sin, -0.0f, -0.0f }, { lanes_sin, TINY, TINY },
    { lanes_sin, -TINY, -TINY }, { lanes_sin, INF, NAN }, { lanes_sin, -INF, NAN },
    { lanes_sin, NAN, NAN }, { lanes_sin, 0x1.921fb6p0f, 1.0f },

    { lanes_cos, 0.0f, 1.0f }, { lanes_cos, -0.0f, 1.0f }, { lanes_cos, TINY, 1.0f },
    { lanes_cos, -TINY, 1.0f }, { lanes_cos, INF, NAN }, { lanes_cos, -INF, NAN },
    { lanes_cos, NAN, NAN }, { lanes_cos, 0x1.921fb6p1f, -1.0f },
};
/* clang-format on */

static void r52_edges_of_one_argument_are_as_documented(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(edges); i++) {
        float result = one(edges[i].function, edges[i].x);
        if (!same_bits_or_both_nan(result, edges[i].result))
            fail_msg("edge %zu: f(%a) = %a, not %a", i, (double)edges[i].x, (double)result,
                     (double)edges[i].result);
    }
}

static void r52_every_nan_gives_a_nan(void **state)
{
    (void)state;
    for (uint32_t payload = 1; payload < 0x800000; payload += 4099)
        for (size_t i = 0; i < GP_COUNT(detmath_functions); i++) {
            flt (*function)(flt) = detmath_functions[i].lanes;
            assert_true(isnan(one(function, gp_bits_float(0x7f800000 | payload))));
            assert_true(isnan(one(function, gp_bits_float(0xff800000 | payload))));
        }
}

static void r52_edges_of_pow_are_as_documented(void **state)
{
    (void)state;
    /* clang-format off */
    static const struct { float x, y, result; } cases[] = {
        { 0.0f, 0.0f, 1.0f }, { -0.0f, 0.0f, 1.0f }, { 5.0f, 0.0f, 1.0f }, { 5.0f, -0.0f, 1.0f },
        { TINY, 0.0f, 1.0f }, { INF, 0.0f, NAN }, { NAN, 0.0f, NAN }, { 2.0f, NAN, NAN },
        { 1.0f, 1e30f, 1.0f }, { 1.0f, -1e30f, 1.0f }, { 1.0f, INF, NAN }, { 1.0f, -INF, NAN },
        { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.01f, 0.0f }, { 0.0f, -1.0f, INF }, { -0.0f, -1.0f, INF },
        { 0.0f, INF, 0.0f }, { 0.0f, -INF, INF }, { 0.0f, 0x1p-120f, 0.0f },
        { 0.0f, -0x1p-120f, INF }, { 0.0f, NAN, NAN }, { INF, 0.5f, INF }, { INF, -0.5f, 0.0f },
        { INF, INF, INF }, { INF, -INF, 0.0f }, { -INF, 0.5f, INF }, { 0.5f, INF, 0.0f },
        { 0.5f, -INF, INF }, { 2.0f, INF, INF }, { 2.0f, -INF, 0.0f }, { -2.0f, 3.0f, 8.0f },
        { -2.0f, -1.0f, 0.5f }, { 2.0f, 128.0f, INF }, { 2.0f, -149.0f, TINY },
        { 2.0f, -151.0f, 0.0f }, { 4.0f, 0.5f, 2.0f }, { TINY, 1.0f, TINY },
        { 0.5f, 1e30f, 0.0f }, { 2.0f, FLT_MAX, INF }, { NAN, NAN, NAN },
    };
    /* clang-format on */
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        float result = one_pow(cases[i].x, cases[i].y);
        if (!same_bits_or_both_nan(result, cases[i].result))
            fail_msg("pow(%a, %a) = %a, not %a", (double)cases[i].x, (double)cases[i].y,
                     (double)result, (double)cases[i].result);
    }
}

static void scalar_entry_points_give_the_bits_of_a_lane(void **state)
{
    (void)state;
    for (uint64_t bits = 0; bits < UINT64_C(1) << 32; bits += 1000003) {
        float x = gp_bits_float((uint32_t)bits);
        assert_true(same_bits_or_both_nan(gp_exp2(x), one(lanes_exp2, x)));
        assert_true(same_bits_or_both_nan(gp_log2(x), one(lanes_log2, x)));
        assert_true(same_bits_or_both_nan(gp_sin(x), one(lanes_sin, x)));
        assert_true(same_bits_or_both_nan(gp_cos(x), one(lanes_cos, x)));
        assert_true(same_bits_or_both_nan(gp_pow(x, 1.5f), one_pow(x, 1.5f)));
    }
}

/* --- the same bits everywhere ----------------------------------------------------------------- */

enum { BATCH = 4096 }; /* a multiple of every lane count */

/* Adds the results to the hash; NaNs by one pattern, as their payloads are not promised. */
static void hash_results(XXH3_state_t *hash, float *results)
{
    for (int i = 0; i < BATCH; i++)
        if (isnan(results[i]))
            results[i] = gp_bits_float(0x7fc00000);
    XXH3_64bits_update(hash, results, BATCH * sizeof *results);
}

/* This constant is the same for every compiler, optimisation level, lane count and machine. */
static void r50_results_are_the_same_bits_in_every_build(void **state)
{
    (void)state;
    static float x[BATCH], y[BATCH], result[BATCH];
    XXH3_state_t *hash = XXH3_createState();
    assert_non_null(hash);
    XXH3_64bits_reset(hash);
    uint32_t bits = 0;
    for (int batch = 0; batch < 96; batch++) {
        for (int i = 0; i < BATCH; i++, bits += 10007)
            x[i] = gp_bits_float(bits);
        for (int i = 0; i < BATCH; i++)
            y[i] = x[(i * 5 + 1) % BATCH] * 0x1p-20f;
        for (size_t f = 0; f <= GP_COUNT(detmath_functions); f++) {
            for (int i = 0; i < BATCH; i += GP_LANES) {
                flt a, b, r;
                memcpy(&a, x + i, sizeof a);
                memcpy(&b, y + i, sizeof b);
                r = f < GP_COUNT(detmath_functions) ? detmath_functions[f].lanes(a)
                                                    : math_pow(a, b);
                memcpy(result + i, &r, sizeof r);
            }
            hash_results(hash, result);
        }
    }
    uint64_t digest = XXH3_64bits_digest(hash);
    XXH3_freeState(hash);
    assert_int_equal(digest, UINT64_C(0x4bdd0fe1cbbd5c77));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r50_floor_frc_and_rcp_are_exact),
        cmocka_unit_test(r51_rcp_and_rsq_are_divisions_not_estimates),
        cmocka_unit_test(r52_rsq_exp2_log2_sin_cos_are_within_two_ulp),
        cmocka_unit_test(r52_pow_of_random_pairs_has_15_bits),
        cmocka_unit_test(r52_pow_of_structured_pairs_has_15_bits),
        cmocka_unit_test(r52_exp2_and_log2_are_exact_at_powers_of_two),
        cmocka_unit_test(r29_exp2_underflows_gradually),
        cmocka_unit_test(r52_sin_is_odd_cos_is_even_and_both_stay_in_range),
        cmocka_unit_test(r52_edges_of_one_argument_are_as_documented),
        cmocka_unit_test(r52_every_nan_gives_a_nan),
        cmocka_unit_test(r52_edges_of_pow_are_as_documented),
        cmocka_unit_test(scalar_entry_points_give_the_bits_of_a_lane),
        cmocka_unit_test(r50_results_are_the_same_bits_in_every_build),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
