/* Polynomials from text against the same in C, and what is wrong with others. */
#include "apps/base/polynomial.h"
#include "tests/support/polynomial_value.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

static double plain_quartic(const double p[3])
{
    double sum = 11.8;
    for (int k = 0; k < 3; k++)
        sum += p[k] * p[k] * p[k] * p[k] - 5 * p[k] * p[k];
    return sum;
}

static double plain_heart(const double p[3])
{
    const double x = p[0], y = p[1], z = p[2], sum = x * x + 9.0 / 4 * y * y + z * z - 1;
    return sum * sum * sum - x * x * z * z * z - 9.0 / 80 * y * y * z * z * z;
}

static double plain_mix(const double p[3])
{
    const double x = p[0], y = p[1], z = p[2];
    return 2 * x * (y - 3) - -z * z + 1.5e1 / 4 + x * x * x * y * z - 0.25;
}

static const char heart[] = "(x^2 + 9/4 y^2 + z^2 - 1)^3 = x^2 z^3 + 9/80 y^2z^3";

static void polynomials_are_read_as_written(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double (*plain)(const double p[3]);
    } cases[] = {
        { "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8=0", plain_quartic },
        { heart, plain_heart },
        { " 2x(y - 3) + z z + 1.5e1/4+x^3*y*z = 1/4 ", plain_mix },
    };
    Random random = { 3 };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        Polynomial polynomial;
        GpError error = { "" };
        if (polynomial_parse(cases[i].text, &polynomial, &error))
            fail_msg("%s", error.text);
        for (int n = 0; n < 50; n++) {
            double p[3];
            for (int k = 0; k < 3; k++)
                p[k] = (double)random_float(&random, -3, 3);
            const double value = polynomial_value(&polynomial, p);
            assert_true(fabs(value - cases[i].plain(p)) <= 1e-9 * (1 + fabs(value)));
        }
    }
}

static void bad_polynomials_are_refused_with_their_column(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reason;
    } cases[] = {
        { "", "column 1: expected a number, x, y, z or (, but the text ends" },
        { "x^2 + a", "column 7: expected a number, x, y, z or (, found 'a'" },
        { "x^2 - 1 = 0 = y", "column 13: expected +, -, *, /, ^ or =, found '='" },
        { "(x + y", "column 7: expected +, - or ), but the text ends" },
        { "x^y", "column 3: expected a whole number, found 'y'" },
        { "1 + x^9", "column 5: the degree is above 8" },
        { "x^6(y^2 + z^3)", "column 4: the degree is above 8" },
        { "x^1000", "column 1: a power that is too high" },
        { "x / y", "column 5: only numbers can divide" },
        { "x/(1-1)", "column 3: division by 0" },
        { "x + 1e99", "column 5: a number that is too large" },
        { "10^40 x", "'10^40 x': a factor is too large" },
        { "x - x + 3", "'x - x + 3': no x, y or z is left" },
        { "x + .", "column 5: expected a digit, found '.'" },
        { "x y )", "column 5: expected +, -, *, /, ^ or =, found ')'" },
        { "((((((((((((((((((((((((((((((((((x))))))))))))))))))))))))))))))))))",
          "column 33: too many brackets in brackets" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        Polynomial untouched = { .c[1][1][1] = 7 };
        GpError error = { "" };
        assert_int_equal(polynomial_parse(cases[i].text, &untouched, &error), GP_ERROR_INVALID);
        assert_string_equal(error.text, cases[i].reason);
        assert_true(untouched.c[1][1][1] == 7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_are_read_as_written),
        cmocka_unit_test(bad_polynomials_are_refused_with_their_column),
    };
    return cmocka_run_group_tests_name("polynomials", tests, NULL, NULL);
}
