/* Parts of pages: base64 against a reader of its digits, and cells; the rows of RFC 4648 are in
 * test_chart_picture.c. */
#include "apps/base/page.h"

#include "tests/support/random.h"
#include "tests/support/unit.h"

static unsigned value_of(char digit)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *place = strchr(digits, digit);
    assert_true(digit && place);
    return (unsigned)(place - digits);
}

/* Few, and around the length of the blocks that it is made in. */
static void bytes_of_any_number_come_back(void **state)
{
    (void)state;
    static unsigned char bytes[9300];
    Random random = { 1 };
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (unsigned char)random_word(&random);
    for (size_t size = 0; size <= sizeof bytes; size = size == 20     ? 3060
                                                       : size == 3090 ? 9200
                                                                      : size + 1) {
        Text page = { .data = NULL };
        page_add_base64(&page, bytes, size);
        assert_int_equal(page.length, (size + 2) / 3 * 4);
        const size_t ends = (3 - size % 3) % 3;
        for (size_t i = 0; i < ends; i++)
            assert_int_equal(page.data[page.length - 1 - i], '=');
        for (size_t i = 0; i < size; i++) {
            const size_t bit = 8 * i, digit = bit / 6;
            const unsigned first = value_of(page.data[digit]),
                           second = value_of(page.data[digit + 1]);
            const unsigned both = first << 6 | second;
            assert_int_equal(both >> (4 - bit % 6) & 255, bytes[i]);
        }
        text_free(&page);
    }
}

static void cells_are_escaped(void **state)
{
    (void)state;
    Text page = { .data = NULL };
    page_add_cell(&page, "td", " class=\"n\"", "a < b & \"c\"");
    assert_string_equal(page.data, "<td class=\"n\">a &lt; b &amp; &quot;c&quot;</td>");
    text_free(&page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_of_any_number_come_back),
        cmocka_unit_test(cells_are_escaped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
