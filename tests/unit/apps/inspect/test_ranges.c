/* Ranges of surfaces, and the first lines of statements. */
#include "apps/inspect/ranges.h"
#include "apps/inspect/sources.h"
#include "tests/support/unit.h"

#include <math.h>

static json_int_t bin(const json_t *range, size_t i)
{
    return json_integer_value(json_array_get(json_object_get(range, "bins"), i));
}

static double number(const json_t *range, const char *key)
{
    return json_number_value(json_object_get(range, key));
}

static void values_fall_into_bins_from_the_least_to_the_largest(void **state)
{
    const float texels[] = { -1, 0, 1, 3, 3, NAN, -INFINITY, 2.99f };
    const GpSurface surface = { .format = GP_R32F, .width = 4, .height = 2 };
    (void)state;
    json_t *list = ranges_tell(&surface, (const uint8_t *)texels);
    const json_t *red = json_array_get(list, 0);
    assert_int_equal(json_array_size(list), 1);
    assert_true(number(red, "low") == -1 && number(red, "high") == 3);
    assert_int_equal(number(red, "odd"), 2);
    assert_int_equal(bin(red, 0), 1);
    assert_int_equal(bin(red, RANGE_BINS / 4 - 1) + bin(red, RANGE_BINS / 4), 1);
    assert_int_equal(bin(red, RANGE_BINS - 1), 3);
    json_decref(list);
}

static void each_channel_has_its_own_and_an_even_one_is_in_one_bin(void **state)
{
    const uint8_t texels[] = { 10, 20, 30, 255, 10, 20, 40, 255 }; /* b, g, r, a */
    const uint32_t depths[] = { 7u | 0xffffff00u, 9u };
    const GpSurface color = { .format = GP_A8R8G8B8, .width = 2, .height = 1 };
    const GpSurface depth = { .format = GP_D24S8, .width = 2, .height = 1 };
    (void)state;
    json_t *list = ranges_tell(&color, texels);
    assert_int_equal(json_array_size(list), 4);
    assert_true(number(json_array_get(list, 0), "low") == (double)(30 / 255.0f));
    assert_true(number(json_array_get(list, 0), "high") == (double)(40 / 255.0f));
    assert_int_equal(bin(json_array_get(list, 3), 0), 2);
    json_decref(list);
    list = ranges_tell(&depth, (const uint8_t *)depths);
    assert_int_equal(json_array_size(list), 2);
    assert_true(number(json_array_get(list, 0), "low") == 0 &&
                number(json_array_get(list, 0), "high") == 1);
    assert_true(number(json_array_get(list, 1), "low") == 7 &&
                number(json_array_get(list, 1), "high") == 9);
    json_decref(list);
}

/* Compilers differ in which line of a statement an operator is on. */
static void every_line_of_a_statement_has_the_same_first_line(void **state)
{
    static const char text[] = "int a;\n"
                               "/* about b */\n"
                               "int b = a +\n"
                               "        1 + /* one; */\n"
                               "        2;\n"
                               "if (a)\n"
                               "    b = 3;\n"
                               "\n"
                               "void f(void)\n"
                               "{\n"
                               "    a = b\n"
                               "        + 1;\n";
    const PageFile file = { "text.c", text, text + sizeof text - 1 };
    static const int first[] = { 1, 2, 3, 3, 3, 6, 6, 8, 9, 9, 11, 11 };
    (void)state;
    for (int line = 1; line <= (int)GP_COUNT(first); line++)
        assert_int_equal(source_statement_line(&file, line), first[line - 1]);
    assert_int_equal(source_statement_line(NULL, 5), 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_fall_into_bins_from_the_least_to_the_largest),
        cmocka_unit_test(each_channel_has_its_own_and_an_even_one_is_in_one_bin),
        cmocka_unit_test(every_line_of_a_statement_has_the_same_first_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
