/* Transfer functions are read to the letter, and straight between their stops. */
#include "apps/volumes/transfer.h"
#include "tests/support/folder.h"

#include <math.h>

static const Field bytes = { .most = 255 }, numbers = { .least = -1000, .most = 3000 };
static GpError error;

static Transfer read_text(const Field *field, const char *text)
{
    Transfer transfer;
    if (transfer_open(put_text("a.txt", text), field, &transfer, &error) != GP_OK)
        fail_msg("%s", error.text);
    return transfer;
}

static void comments_returns_and_a_last_line_without_end_are_fine(void **state)
{
    (void)state;
    const Transfer transfer = read_text(&bytes, "# a comment\r\n\r\n0 0 .5 1 0\r\n"
                                                "\t 10.5  1 1 1 0.25 # glass\r\n  # more\n"
                                                "255 1e-1 +1 0 1");
    assert_int_equal(transfer.count, 3);
    assert_true(transfer.stops[1].value == 10.5 && transfer.stops[1].rgba[3] == 0.25);
    assert_true(transfer.stops[0].rgba[1] == 0.5 && transfer.stops[2].rgba[1] == 1);
}

static void what_is_wrong_is_said_with_its_line(void **state)
{
    (void)state;
    static const struct {
        const char *text, *part;
    } cases[] = {
        { "", "a.txt: the file is empty" },
        { "\n# nothing\n", "a.txt: no stops, expected lines of value r g b a" },
        { "0 0 0 0 0\n1 1 1 1\n", "a.txt: line 2: the line ends, expected opacity" },
        { "0 0 0 # 0 0\n", "line 1: the line ends, expected blue" },
        { "0 0 0 0 0 0\n", "line 1: expected value r g b a and no '0' behind them" },
        { "0 0 red 0 0\n", "line 1: expected a number for green, not 'red'" },
        { "0 0 nan 0 0\n", "line 1: expected a number for green, not 'nan'" },
        { "0 0 0 0 inf\n", "line 1: expected a number for opacity, not 'inf'" },
        { "0 0 0 0 0x1\n", "line 1: expected a number for opacity, not '0x1'" },
        { "0 0 0 0 1e99\n", "line 1: expected a number for opacity" },
        { "0 0 0 0 1.01\n", "line 1: expected opacity of 0 to 1, not 1.01" },
        { "0 -.1 0 0 0\n", "line 1: expected red of 0 to 1, not -.1" },
        { "256 0 0 0 0\n", "line 1: expected a value of 0 to 255, not 256" },
        { "-1 0 0 0 0\n", "line 1: expected a value of 0 to 255, not -1" },
        { "0 0 0 0 0\n#\n9 0 0 0 0\n9 1 1 1 1\n",
          "line 4: expected values that rise, and 9 is not above 9" },
        { "9 0 0 0 0\n5 1 1 1 1\n", "line 2: expected values that rise, and 5 is not above 9" },
        { "0;0;0;0;0\n", "line 1: expected a number for a value, not '0;0;0;0;0'" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        Transfer transfer = { .count = 77 };
        const GpResult result =
            transfer_open(put_text("a.txt", cases[i].text), &bytes, &transfer, &error);
        if (result != GP_ERROR_FORMAT || !strstr(error.text, cases[i].part))
            fail_msg("case %zu: %s", i, error.text);
        assert_int_equal(transfer.count, 77);
    }
    char many[8000] = "";
    size_t length = 0;
    for (int i = 0; i < 257; i++)
        length += (size_t)sprintf(many + length, "%g 0 0 0 0\n", i * 0.5);
    Transfer transfer;
    assert_int_equal(transfer_open(put_text("a.txt", many), &bytes, &transfer, &error),
                     GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "line 257: expected at most 256 stops"));
    assert_int_equal(transfer_open(in_folder("b.txt"), &bytes, &transfer, &error), GP_ERROR_IO);
}

/* Every beginning of a file is read or refused, and never half. */
static void every_beginning_is_read_or_refused(void **state)
{
    (void)state;
    static const char text[] = "0 0 0 0 0\n25.5 .2 .6 .2 0 # leaf\n255 1 1 .9 .3\n";
    int read = 0;
    for (size_t size = 0; size < sizeof text; size++) {
        Transfer transfer = { .count = 77 };
        const GpResult result =
            transfer_open(put_file("a.txt", text, size), &bytes, &transfer, &error);
        assert_true(result == GP_OK || result == GP_ERROR_FORMAT);
        assert_true(result == GP_OK ? transfer.count <= 3 : transfer.count == 77);
        read += result == GP_OK;
    }
    assert_true(read > 10);
}

static void it_is_straight_between_stops_and_level_beyond(void **state)
{
    (void)state;
    const Transfer transfer = read_text(&bytes, "10 0 1 .5 0\n30 1 0 .5 .5\n");
    static const double values[] = { 0, 10, 15, 30, 200 }, reds[] = { 0, 0, 0.25, 1, 1 };
    float table[FIELD_VALUES][4];
    transfer_table(&transfer, table);
    for (size_t i = 0; i < GP_COUNT(values); i++) {
        double rgba[4];
        transfer_at(&transfer, values[i], rgba);
        assert_true(rgba[0] == reds[i] && rgba[1] == 1 - reds[i] && rgba[2] == 0.5);
        assert_true(rgba[3] == reds[i] / 2 && table[(int)values[i]][3] == (float)rgba[3]);
    }
}

static void values_of_a_field_without_bytes_go_from_its_least_to_its_greatest(void **state)
{
    (void)state;
    const Transfer transfer = read_text(&numbers, "-500 0 0 0 0\n0 .5 0 0 0\n1500 1 1 1 1\n");
    assert_true(transfer.stops[0].value == 0 && transfer.stops[2].value == 255);
    assert_true(fabs(transfer.stops[1].value - 63.75) < 1e-12);
    assert_true(read_text(&numbers, "70000 0 0 0 0\n").stops[0].value == 0);
}

static void those_built_in_have_values_that_rise(void **state)
{
    (void)state;
    for (int i = 0; transfer_names[i]; i++) {
        Transfer transfer;
        assert_int_equal(transfer_open(transfer_names[i], &bytes, &transfer, &error), GP_OK);
        assert_true(transfer.count >= 2);
        for (uint32_t k = 1; k < transfer.count; k++)
            assert_true(transfer.stops[k].value > transfer.stops[k - 1].value);
    }
}

static void extinction_is_that_of_the_slab(void **state)
{
    (void)state;
    assert_true(transfer_extinction(0) == 0);
    assert_true(fabs(transfer_extinction(0.5) - log(2)) < 1e-15);
    assert_true(fabs(transfer_extinction(1) - 24 * log(2)) < 1e-13);
}

static void one_is_chosen_for_any_field(void **state)
{
    (void)state;
    static const char *const names[] = { "builtin:ball:20", "builtin:checkerboard:40",
                                         "builtin:marschner-lobb:20", "builtin:ball:1" };
    for (size_t i = 0; i < 256 + GP_COUNT(names); i++) {
        uint8_t same[8];
        Field field = { .size = { 2, 2, 2 }, .value = same };
        memset(same, (int)i, sizeof same);
        if (i >= 256)
            assert_int_equal(field_open(names[i - 256], &field, &error), GP_OK);
        Transfer transfer;
        transfer_choose(&field, &transfer);
        for (uint32_t k = 0; k < transfer.count; k++) {
            const TransferStop *stop = &transfer.stops[k];
            assert_true(stop->value >= 0 && stop->value <= 255);
            assert_true(k == 0 || stop->value > stop[-1].value);
            for (int c = 0; c < 4; c++)
                assert_true(stop->rgba[c] >= 0 && stop->rgba[c] <= 1);
        }
        if (i >= 256)
            field_free(&field);
    }
}

/* A thin shell of 200 and a large inside of 97, in air of 0 to 7. */
static void around_is_nothing_and_what_is_rare_shows_most(void **state)
{
    (void)state;
    enum { SIDE = 40 };
    Field field = { .size = { SIDE, SIDE, SIDE }, .scale = { 1, 1, 1 } };
    field.value = malloc(SIDE * SIDE * SIDE);
    for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
        const int x = i % SIDE - 20, y = i / SIDE % SIDE - 20, z = i / SIDE / SIDE - 20;
        const int r2 = x * x + y * y + z * z;
        field.value[i] = (uint8_t)(r2 > 256 ? i % 8 : r2 > 225 ? 200 : 97);
    }
    Transfer transfer;
    double air[4], inside[4], shell[4];
    transfer_choose(&field, &transfer);
    transfer_at(&transfer, 7, air);
    transfer_at(&transfer, 97, inside);
    transfer_at(&transfer, 200, shell);
    assert_true(air[3] < inside[3] / 2 && inside[3] > 0.005 && inside[3] < 0.2);
    assert_true(shell[3] > 2 * inside[3]);
    free(field.value);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(comments_returns_and_a_last_line_without_end_are_fine,
                                        folder_set_up, folder_tear_down),
        cmocka_unit_test_setup_teardown(what_is_wrong_is_said_with_its_line, folder_set_up,
                                        folder_tear_down),
        cmocka_unit_test_setup_teardown(every_beginning_is_read_or_refused, folder_set_up,
                                        folder_tear_down),
        cmocka_unit_test_setup_teardown(it_is_straight_between_stops_and_level_beyond,
                                        folder_set_up, folder_tear_down),
        cmocka_unit_test_setup_teardown(
            values_of_a_field_without_bytes_go_from_its_least_to_its_greatest, folder_set_up,
            folder_tear_down),
        cmocka_unit_test(those_built_in_have_values_that_rise),
        cmocka_unit_test(extinction_is_that_of_the_slab),
        cmocka_unit_test(one_is_chosen_for_any_field),
        cmocka_unit_test(around_is_nothing_and_what_is_rare_shows_most),
    };
    return cmocka_run_group_tests_name("transfer", tests, NULL, NULL);
}
