/* Alpha test: every function, exact against reference / 255, of target 0 alone. */
#include "pipeline/units/alpha_test.h"
#include "tests/support/unit.h"

#include <math.h>

static unsigned tested(GpCompare test, uint8_t reference, const float alpha[4], unsigned mask)
{
    GpQuad quad = { .mask = mask };
    for (int pixel = 0; pixel < 4; pixel++) {
        quad.color[0][3][pixel] = alpha[pixel];
        quad.color[0][0][pixel] = quad.color[1][3][pixel] = 1 - alpha[pixel]; /* not asked */
    }
    gp_alpha_test(&(GpAlphaTest){ test, reference }, &quad);
    return quad.mask;
}

/* Pixels: a step below the reference, the reference, a step above, NaN. */
static void every_function_divides_at_the_reference(void **state)
{
    (void)state;
    static const unsigned kept[GP_COMPARES] = {
        [GP_ALWAYS] = 15,       [GP_NEVER] = 0,   [GP_LESS] = 1,       [GP_EQUAL] = 2,
        [GP_LESS_EQUAL] = 3,    [GP_GREATER] = 4, [GP_NOT_EQUAL] = 13, /* NaN differs from all */
        [GP_GREATER_EQUAL] = 6,
    };
    for (int reference = 0; reference < 256; reference++) {
        const float at = (float)reference / 255.0f;
        const float alpha[4] = { nextafterf(at, -1), at, nextafterf(at, 2), NAN };
        for (int test = 0; test < GP_COMPARES; test++)
            assert_int_equal(tested((GpCompare)test, (uint8_t)reference, alpha, 15), kept[test]);
    }
}

static void pixels_that_are_dead_stay_dead(void **state)
{
    (void)state;
    const float alpha[4] = { 1, 1, 0, 1 };
    for (unsigned mask = 0; mask < 16; mask++) {
        assert_int_equal(tested(GP_ALWAYS, 0, alpha, mask), mask);
        assert_int_equal(tested(GP_GREATER, 128, alpha, mask), mask & 11);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_function_divides_at_the_reference),
        cmocka_unit_test(pixels_that_are_dead_stay_dead),
    };
    return cmocka_run_group_tests_name("alpha_test", tests, NULL, NULL);
}
