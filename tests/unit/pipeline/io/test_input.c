/* Numbers of text files: the floats that are nearest to them, and nothing else that looks like a
 * number. */
#include "pipeline/io/input.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <stdio.h>
#include <stdlib.h>

static bool read_number(char *text, float *value)
{
    const GpWord word = { .text = text, .size = strlen(text) };
    return gp_word_number(&word, value);
}

/* strtof of the C library rounds to nearest. */
static void check(const char *text)
{
    char copy[400];
    float value = -1, expected = strtof(text, NULL);
    snprintf(copy, sizeof copy, "%s", text);
    const bool is_number = read_number(copy, &value);
    if (is_number != (gp_float_bits(expected) << 1 < 0xff000000u))
        fail_msg("%s: %s", text, is_number ? "a number" : "none");
    if (is_number && gp_float_bits(value) != gp_float_bits(expected))
        fail_msg("%s: %.9g, not %.9g", text, (double)value, (double)expected);
}

static void numbers_are_rounded_to_the_nearest_float(void **state)
{
    (void)state;
    static const char *const hard[] = {
        "0",
        "-0",
        "+0.0",
        "0e99",
        "-0e-99",
        "1",
        ".5",
        "5.",
        "5.e0",
        "-1E2",
        "1e+2",
        "007",
        /* halfway between two floats, and beside it */
        "16777217",
        "16777219",
        "-16777217.0",
        "1677721.7e1",
        "16777217.00000000000000001",
        "16777216.99999999999999999",
        "0.500000029802322387695312",
        "0.5000000298023223876953125",
        "0.50000002980232238769531251",
        "9007199791611904",
        "9007199791611905e0",
        /* the last integers of binary64, the last exact powers of ten */
        "9007199254740992",
        "9007199254740993",
        "9007199254740991e22",
        "1e22",
        "1e23",
        "1e-22",
        "1e-23",
        "8.5e22",
        "3e-22",
        /* subnormal floats, their halves, and the least normal one */
        "1.17549435e-38",
        "1.1754943e-38",
        "1e-40",
        "1.4e-45",
        "7.1e-46",
        "7e-46",
        "1e-300",
        "1e-999999999999",
        "0.0000000000000000000000000000000000000000000014",
        /* the greatest, and too great ones */
        "3.4028234e38",
        "3.4028235e38",
        "3.40282356e38",
        "3.4028236e38",
        "34028235e31",
        "1e39",
        "1e999999999999",
        "340282350000000000000000000000000000000",
    };
    for (size_t i = 0; i < GP_COUNT(hard); i++)
        check(hard[i]);
}

static void random_numbers_are_rounded_to_the_nearest_float(void **state)
{
    (void)state;
    Random random = { 2026 };
    char text[64];
    for (int i = 0; i < 200000; i++) {
        const double value = (double)random_float(&random, -1, 1);
        static const char *const formats[] = { "%.4f", "%.6g", "%.9g", "%.17g", "%.8e", "%.0f" };
        snprintf(text, sizeof text, formats[i % 6], i % 6 == 5 ? value * 1e9 : value * (i % 97));
        check(text);
        const uint32_t digits = random_word(&random), more = random_word(&random);
        snprintf(text, sizeof text, "%u%0*u.%ue%d", digits, i % 9, more % 1000u, more >> (i & 31),
                 (int)(more % 90) - 60);
        check(text);
        /* the middle of two floats, as few digits say it */
        const uint32_t odd = 2 * (random_word(&random) >> 8) + 1, shift = random_word(&random) % 20;
        snprintf(text, sizeof text, "%.*f", (int)shift, (double)odd / (double)(1u << shift));
        check(text);
    }
}

static void words_that_are_no_numbers_are_refused(void **state)
{
    (void)state;
    static const char *const words[] = { "",    "+",   "-",    ".",     "+.",   "e5",
                                         "1e",  "1e+", "1e-",  "1e+x",  "1e5x", "0x1",
                                         "nan", "inf", "-inf", "1f",    "1,5",  "1.2.",
                                         "--1", "1-",  "1e5.", "1e1e1", ".e1",  "1 " };
    for (size_t i = 0; i < GP_COUNT(words); i++) {
        char copy[16];
        float value;
        snprintf(copy, sizeof copy, "%s", words[i]);
        if (read_number(copy, &value))
            fail_msg("'%s' is a number", words[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_rounded_to_the_nearest_float),
        cmocka_unit_test(random_numbers_are_rounded_to_the_nearest_float),
        cmocka_unit_test(words_that_are_no_numbers_are_refused),
    };
    return cmocka_run_group_tests_name("input", tests, NULL, NULL);
}
