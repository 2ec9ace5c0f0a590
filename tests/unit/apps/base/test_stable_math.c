/* The stable functions against those of long double, which have eleven bits more. */
#include "apps/base/stable_math.h"
#include "pipeline/base/base.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <float.h>
#include <math.h>

/* Units in the last place between a value and the truth. */
static double ulps(double value, long double truth)
{
    const long double unit = ldexpl(1, ilogbl(truth) - (DBL_MANT_DIG - 1));
    return (double)fabsl(((long double)value - truth) / unit);
}

static void random_arguments_have_the_errors_that_are_stated(void **state)
{
    (void)state;
    Random random = { 7 };
    double worst[3] = { 0 };
    for (int i = 0; i < 200000; i++) {
        const double x = (double)random_float(&random, -690, 690);
        const double base = exp((double)random_float(&random, -9.2f, 9.2f));
        const double power = (double)random_float(&random, -4, 4);
        const double found[3] = { ulps(stable_exp(x), expl((long double)x)),
                                  ulps(stable_log(exp(x)), logl((long double)exp(x))),
                                  ulps(stable_pow(base, power),
                                       powl((long double)base, (long double)power)) };
        for (int f = 0; f < 3; f++)
            worst[f] = found[f] > worst[f] ? found[f] : worst[f];
    }
    if (worst[0] > 1.5 || worst[1] > 2)
        fail_msg("exp %.2f ulp, log %.2f ulp", worst[0], worst[1]);
    if (worst[2] * DBL_EPSILON > 1e-14)
        fail_msg("pow %.2f ulp", worst[2]);
}

static void arguments_near_one_keep_their_digits(void **state)
{
    (void)state;
    for (int i = 1; i < 50; i++) {
        const double x = 1 + ldexp(1, -i), y = 1 - ldexp(1, -i - 1);
        assert_true(ulps(stable_log(x), logl((long double)x)) < 2);
        assert_true(ulps(stable_log(y), logl((long double)y)) < 2);
    }
}

static void powers_side_by_side_have_the_bits_of_one_alone(void **state)
{
    (void)state;
    Random random = { 11 };
    static const double bases[] = {
        0, 1, DBL_MIN, 0x1p-900, 0.5, 0x1.6a09e667f3bccp-1, 7, 0x1p900
    };
    for (int i = 0; i < 100000; i++) {
        StablePair x[3], y, power[3];
        const double same =
            i % 5 ? (double)random_float(&random, -1, 1) : random_int(&random, 0, 1);
        for (int k = 0; k < 6; k++)
            x[k / 2][k % 2] = random_int(&random, 0, 3)
                                  ? exp((double)random_float(&random, -9.2f, 9.2f))
                                  : bases[random_int(&random, same < 0, GP_COUNT(bases) - 1)];
        y = (StablePair){ same, (double)random_float(&random, 0, 1) };
        stable_pow_pairs(x, same, power);
        const StablePair own = stable_pow_pair(x[0], y);
        for (int k = 0; k < 6; k++)
            assert_true(power[k / 2][k % 2] == stable_pow(x[k / 2][k % 2], same));
        for (int k = 0; k < 2; k++)
            assert_true(own[k] == stable_pow(x[0][k], y[k]));
    }
}

static void edges_are_those_that_are_promised(void **state)
{
    (void)state;
    assert_true(stable_exp(0) == 1 && stable_exp(-800) == 0 && isinf(stable_exp(800)));
    assert_true(isnan(stable_exp((double)NAN)) && isnan(stable_log((double)NAN)));
    assert_true(stable_log(1) == 0 && stable_log(0) == -HUGE_VAL && isnan(stable_log(-1)));
    assert_true(stable_log(HUGE_VAL) == HUGE_VAL);
    assert_true(fabs(stable_log(0x1p-1074) + 1074 * log(2)) < 1e-10);
    assert_true(stable_pow(0, 0) == 1 && stable_pow(0, 2) == 0 && stable_pow(7, 0) == 1);
    assert_true(stable_pow(1, 0.3) == 1);
}

static void angles_are_those_of_long_double_all_round(void **state)
{
    (void)state;
    Random random = { 9 };
    double worst = 0;
    for (int i = 0; i < 200000; i++) {
        const double y = (double)random_float(&random, -1, 1),
                     x = (double)random_float(&random, -1, 1);
        const double scale = i & 1 ? 1e-9 : 1;
        const double off =
            ulps(stable_atan2(y * scale, x), atan2l((long double)(y * scale), (long double)x));
        worst = off > worst ? off : worst;
    }
    if (!(worst <= 3))
        fail_msg("atan2 %.2f ulp", worst);
    assert_true(stable_atan2(0, 0) == 0 && stable_atan2(0, 2) == 0);
    assert_true(stable_atan2(3, 0) == acos(0) && stable_atan2(-3, 0) == -acos(0));
    assert_true(stable_atan2(0, -2) == acos(-1) && stable_atan2(1, 1) == acos(0) / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_arguments_have_the_errors_that_are_stated),
        cmocka_unit_test(arguments_near_one_keep_their_digits),
        cmocka_unit_test(powers_side_by_side_have_the_bits_of_one_alone),
        cmocka_unit_test(edges_are_those_that_are_promised),
        cmocka_unit_test(angles_are_those_of_long_double_all_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
