/* Text that grows: what is escaped, what is quoted, and that numbers come back. */
#include "apps/base/text.h"
#include "tests/support/unit.h"

#include <math.h>
#include <stdlib.h>

static void escaping_is_for_what_stands_for_s(void **state)
{
    (void)state;
    Text text = { .data = NULL };
    text_add_escaped(&text, "<a b='%s'>%d %5.2f%% %u", "<&>\"'\x01\n", -3, 1.5, 7u);
    text_add_escaped(&text, "%s", "");
    text_add_escaped(&text, "|%.3g|%s|</a>", 1e-9, "\xc3\xa9");
    assert_string_equal(text.data,
                        "<a b='&lt;&amp;&gt;&quot;&#39; \n'>-3  1.50% 7|1e-09|\xc3\xa9|</a>");
    assert_int_equal(text.length, strlen(text.data));
    text_free(&text);
}

static void csv_is_quoted_where_it_must_be(void **state)
{
    (void)state;
    Text text = { .data = NULL };
    text_add_csv(&text, "plain words", ",");
    text_add_csv(&text, "a,b", ",");
    text_add_csv(&text, "\"c\"", "\n");
    assert_string_equal(text.data, "plain words,\"a,b\",\"\"\"c\"\"\"\n");
    text_free(&text);
}

static void numbers_come_back_bit_by_bit(void **state)
{
    (void)state;
    const double values[] = { 0, -0.0, 1.0 / 3, 0.1, 1e300, 5e-324, -HUGE_VAL };
    for (size_t i = 0; i < GP_COUNT(values); i++) {
        char text[32];
        text_of_number(values[i], text);
        const double back = strtod(text, NULL);
        assert_memory_equal(&back, &values[i], sizeof back);
    }
}

static void numbers_are_written_as_people_do(void **state)
{
    (void)state;
    static const struct {
        double value;
        int digits;
        const char *text;
    } cases[] = {
        { 0, 3, "0" },
        { 7, 3, "7" },
        { 1234567, 6, "1,234,567" },
        { 999, 3, "999" },
        { 1000, 3, "1,000" },
        { 12345.678, 3, "12,346" },
        { 0.1, 3, "0.1" },
        { 0.00001, 3, "0.00001" },
        { 2.0 / 3, 3, "0.667" },
        { 12.5, 3, "12.5" },
        { 12.04, 3, "12" },
        { 99.96, 3, "100" },
        { 1.25e-9, 3, "1.25 x 10^-9" },
        { 3e15, 3, "3 x 10^15" },
        { -1500.5, 6, "-1,500.5" },
        { 4096, 2, "4,096" },
        { 100, 3, "100" },
        { HUGE_VAL, 3, "inf" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        char text[32];
        text_for_people(cases[i].value, cases[i].digits, text);
        assert_string_equal(text, cases[i].text);
    }
}

static void names_are_cut_out_of_paths(void **state)
{
    (void)state;
    static const char *const paths[][2] = {
        { "a/b/c.json", "c" }, { "c", "c" }, { "a.b/.c", ".c" }, { "x.tar.gz", "x.tar" }
    };
    for (size_t i = 0; i < GP_COUNT(paths); i++) {
        char name[16];
        text_stem(paths[i][0], name, sizeof name);
        assert_string_equal(name, paths[i][1]);
    }
}

static void bytes_that_are_no_character_are_replaced(void **state)
{
    (void)state;
    static const char *const good[] = { "a",
                                        "\x7f",
                                        "\xc2\x80",
                                        "\xdf\xbf",
                                        "\xe0\xa0\x80",
                                        "\xed\x9f\xbf",
                                        "\xee\x80\x80",
                                        "\xf0\x90\x80\x80",
                                        "\xf4\x8f\xbf\xbf" };
    /* alone, too long, a surrogate, beyond U+10FFFF, cut */
    static const char *const bad[] = { "",
                                       "\x80",
                                       "\xc0\x80",
                                       "\xc1\xbf",
                                       "\xff",
                                       "\xe0\x9f\xbf",
                                       "\xed\xa0\x80",
                                       "\xc3",
                                       "\xe2\x82",
                                       "\xc3\x28",
                                       "\xf0\x8f\xbf\xbf",
                                       "\xf0\x90\x80",
                                       "\xf4\x90\x80\x80",
                                       "\xf5\x80\x80\x80",
                                       "\xe2\x28\xa1" };
    for (size_t i = 0; i < GP_COUNT(good); i++)
        assert_int_equal(text_utf8_bytes(good[i]), strlen(good[i]));
    for (size_t i = 0; i < GP_COUNT(bad); i++)
        assert_int_equal(text_utf8_bytes(bad[i]), 0);
    Text text = { .data = NULL };
    text_add_utf8(&text, "a\xff\xc3\xa9\xed\xa0z");
    text_add_escaped(&text, "|%s|", "<\xfe\xe2\x82\xac\xc3");
    assert_string_equal(text.data, "a\xef\xbf\xbd\xc3\xa9\xef\xbf\xbd\xef\xbf\xbdz|&lt;"
                                   "\xef\xbf\xbd\xe2\x82\xac\xef\xbf\xbd|");
    text_free(&text);
}

static void what_is_copied_is_utf_8(void **state)
{
    (void)state;
    char text[8];
    text_copy(text, sizeof text, "a\xc3\xa9z");
    assert_string_equal(text, "a\xc3\xa9z");
    text_copy(text, sizeof text, "a\xe9z");
    assert_string_equal(text, "a?z");
    text_copy(text, 3, "a\xc3\xa9z"); /* cut in the middle of a character */
    assert_string_equal(text, "a?");
}

static void whole_numbers_are_plain_digits(void **state)
{
    (void)state;
    static const char *const wrong[] = { "",   "x1",  "-1",         "+1",
                                         " 1", "101", "4294967296", "99999999999999999999999999" };
    uint32_t value = 7;
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        const char *at = wrong[i];
        assert_false(text_take_whole(&at, 100, &value));
        assert_ptr_equal(at, wrong[i]);
        assert_int_equal(value, 7);
    }
    const char *at = "100 of 4294967295";
    assert_true(text_take_whole(&at, 100, &value));
    assert_int_equal(value, 100);
    assert_false(text_take_word(&at, "of "));
    assert_true(text_take_word(&at, " of "));
    assert_true(text_take_whole(&at, UINT32_MAX, &value));
    assert_int_equal(value, UINT32_MAX);
    assert_string_equal(at, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(escaping_is_for_what_stands_for_s),
        cmocka_unit_test(csv_is_quoted_where_it_must_be),
        cmocka_unit_test(numbers_come_back_bit_by_bit),
        cmocka_unit_test(numbers_are_written_as_people_do),
        cmocka_unit_test(whole_numbers_are_plain_digits),
        cmocka_unit_test(names_are_cut_out_of_paths),
        cmocka_unit_test(bytes_that_are_no_character_are_replaced),
        cmocka_unit_test(what_is_copied_is_utf_8),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
