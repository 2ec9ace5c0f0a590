/* Settings as tables of fields: what texts set, what is printed of them, and how sweeps expand. */
#include "apps/techniques/technique.h"
#include "apps/base/text.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <stdio.h>

typedef struct Setting {
    double bias;
    int method;
    uint32_t map;
} Setting;

static const char *const methods[] = { "plain", "hardware", "soft", NULL };

static const SettingField fields[] = {
    { "method", NULL, "How to look", SETTING_NAME, offsetof(Setting, method), .names = methods },
    { "map", "N", "Side of the map", SETTING_INTEGER, offsetof(Setting, map), .low = 16,
      .high = 8192 },
    { "bias", "X", "Added to depth", SETTING_NUMBER, offsetof(Setting, bias), .low = -1,
      .high = 1 },
    { .name = NULL },
};

static const Setting defaults = { .bias = 0.001, .map = 1024 };

static void expect_same(const Setting *setting, int method, uint32_t map, double bias)
{
    assert_int_equal(setting->method, method);
    assert_int_equal(setting->map, map);
    assert_memory_equal(&setting->bias, &bias, sizeof bias);
}

/* The text must be refused with this message, and the setting must stay as it was. */
static void refused(const char *text, const char *message)
{
    Setting setting = { .bias = 0.5, .method = 2, .map = 77 };
    GpError error = { "" };
    if (setting_parse(fields, &setting, text, &error) != GP_ERROR_INVALID)
        fail_msg("'%s' was not refused", text);
    assert_string_equal(error.text, message);
    expect_same(&setting, 2, 77, 0.5);
}

/* --- reading ---------------------------------------------------------------------------------- */

static void a_text_sets_the_members_that_it_names(void **state)
{
    (void)state;
    Setting setting = defaults;
    GpError error = { "" };
    assert_int_equal(setting_parse(fields, &setting, "", &error), GP_OK);
    expect_same(&setting, 0, 1024, 0.001);
    assert_int_equal(setting_parse(fields, &setting, "  --map 16  --method=soft ", &error), GP_OK);
    expect_same(&setting, 2, 16, 0.001);
    assert_int_equal(setting_parse(fields, &setting, "--bias=-1 --map=8192 --bias 1e-3", &error),
                     GP_OK);
    expect_same(&setting, 2, 8192, 1e-3);
    assert_int_equal(setting_set(fields, &setting, "bias", "+.5", &error), GP_OK);
    assert_int_equal(setting_set(fields, &setting, "method", "hardware", &error), GP_OK);
    expect_same(&setting, 1, 8192, 0.5);
    assert_string_equal(error.text, "");
}

static void mistakes_are_told_with_what_was_expected_and_change_nothing(void **state)
{
    (void)state;
    static const char *const wrong_maps[] = { "15",  "8193", "3x",   "-16", "+16",
                                              "1e3", "0x20", "16.0", "nan", "99999999999999999999",
                                              "" };
    for (size_t i = 0; i < GP_COUNT(wrong_maps); i++) {
        char message[128];
        Setting setting = defaults;
        GpError error = { "" };
        snprintf(message, sizeof message,
                 "--map: expected a whole number from 16 to 8192, not '%s'", wrong_maps[i]);
        assert_int_equal(setting_set(fields, &setting, "map", wrong_maps[i], &error),
                         GP_ERROR_INVALID);
        assert_string_equal(error.text, message);
        expect_same(&setting, 0, 1024, 0.001);
    }
    refused("--map 16 --bias inf", "--bias: expected a number from -1 to 1, not 'inf'");
    refused("--bias 0x1p-3", "--bias: expected a number from -1 to 1, not '0x1p-3'");
    refused("--bias 1.0000001", "--bias: expected a number from -1 to 1, not '1.0000001'");
    refused("--bias 0,5", "--bias: expected a number from -1 to 1, not '0,5'");
    refused("--method fast", "--method: expected plain, hardware or soft, not 'fast'");
    refused("--map 16 --method", "--method: expected a value");
    refused("--method= --map 16", "--method: expected a value");
    refused("--map --bias 0", "--map: expected a whole number from 16 to 8192, not '--bias'");
    refused("--map 16 --maps 16", "no option '--maps'");
    refused("--ma 16", "no option '--ma'");
    refused("map 16", "expected an option, not 'map'");
    refused("--map 16 32", "expected an option, not '32'");
    GpError error = { "" };
    assert_int_equal(setting_set(fields, &(Setting){ 0 }, "size", "1", &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "no option '--size'");
}

/* --- other types ------------------------------------------------------------------------------ */

typedef struct Whole {
    uint32_t size[2];
    double place[3];
    bool fine;
    const char *file;
    uint32_t wide[2];
} Whole;

static const SettingField whole_fields[] = {
    { "size", "WxH", "How large", SETTING_SIZE, offsetof(Whole, size), .low = 1, .high = 640 },
    { "place", "X Y Z", "Where", SETTING_VECTOR, offsetof(Whole, place), .low = -8, .high = 8,
      .count = 3 },
    { "fine", NULL, "How", SETTING_FLAG, .offset = offsetof(Whole, fine) },
    { "file", "FILE", "Of what", SETTING_TEXT, offsetof(Whole, file), .aside = true },
    { "wide", "WxH", "Without a least", SETTING_SIZE, offsetof(Whole, wide), .high = 9,
      .aside = true },
    { .name = NULL },
};

static const Whole whole_defaults = { .size = { 64, 48 } };

static void sizes_vectors_flags_and_texts_are_settings_too(void **state)
{
    (void)state;
    static const int words[] = { 1, 3, 0, 1 };
    Whole whole = whole_defaults;
    GpError error = { "" };
    char text[SETTING_MAX_TEXT];
    for (size_t i = 0; i < GP_COUNT(words); i++)
        assert_int_equal(setting_words(&whole_fields[i]), words[i]);
    assert_int_equal(setting_set(whole_fields, &whole, "file", "a b.ply", &error), GP_OK);
    assert_string_equal(whole.file, "a b.ply");
    setting_print(whole_fields, &whole, &whole_defaults, text, sizeof text);
    assert_string_equal(text, ""); /* aside of the key */
    assert_int_equal(
        setting_parse(whole_fields, &whole, "--place 1 -2.5  1e-3 --fine --size=640x1", &error),
        GP_OK);
    assert_true(whole.place[0] == 1 && whole.place[1] == -2.5 && whole.place[2] == 1e-3);
    assert_true(whole.fine && whole.size[0] == 640 && whole.size[1] == 1);
    setting_print(whole_fields, &whole, &whole_defaults, text, sizeof text);
    assert_string_equal(text, "--size 640x1 --place 1 -2.5 0.001 --fine");
    assert_true(setting_is_given(whole_fields, 1u << 1, "place"));
    assert_false(setting_is_given(whole_fields, 1u << 1, "size"));
}

static void other_types_tell_what_was_expected(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *message;
    } wrong[] = {
        { "size", "64",
          "--size: expected WIDTHxHEIGHT, such as 1024x768, each from 1 to 640, not '64'" },
        { "size", "64x", "not '64x'" },
        { "size", "x64", "not 'x64'" },
        { "size", "64x48x1", "not '64x48x1'" },
        { "size", "641x1", "not '641x1'" },
        { "size", "0x1", "not '0x1'" },
        { "place", "1 2", "--place: expected three numbers from -8 to 8, not ''" },
        { "place", "1 two 3", "not 'two'" },
        { "place", "1 2 8.5", "not '8.5'" },
        { "place", "1 2 3 foo", "not 'foo'" },
        { "place", "1 2 3 4", "not '4'" },
        { "place", "1 2 1.0000000000000000000000000000000x",
          "not '1.00000000000000000000000000...'" },
        { "wide", "0x1", "--wide: expected WIDTHxHEIGHT, such as 1024x768, each from 1 to 9, not" },
        { "wide", "1x0", "not '1x0'" },
    };
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        Whole whole = whole_defaults;
        GpError error = { "" };
        assert_int_equal(setting_set(whole_fields, &whole, wrong[i].name, wrong[i].text, &error),
                         GP_ERROR_INVALID);
        if (!strstr(error.text, wrong[i].message))
            fail_msg("%s: %s", wrong[i].text, error.text);
        assert_memory_equal(&whole, &whole_defaults, sizeof whole);
    }
    Whole whole = whole_defaults;
    GpError error = { "" };
    assert_int_equal(setting_parse(whole_fields, &whole, "--file a", &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "no option '--file'");
    assert_int_equal(setting_parse(whole_fields, &whole, "--fine --place 1 2", &error),
                     GP_ERROR_INVALID);
    assert_false(whole.fine);
}

/* --- printing --------------------------------------------------------------------------------- */

static void only_members_that_differ_are_printed_in_the_tables_order(void **state)
{
    (void)state;
    char text[SETTING_MAX_TEXT];
    Setting setting = defaults;
    setting_print(fields, &setting, &defaults, text, sizeof text);
    assert_string_equal(text, "");
    setting = (Setting){ .bias = 0.1, .method = 1, .map = 2048 };
    setting_print(fields, &setting, &defaults, text, sizeof text);
    assert_string_equal(text, "--method hardware --map 2048 --bias 0.1");
    setting.map = defaults.map;
    setting_print(fields, &setting, &defaults, text, sizeof text);
    assert_string_equal(text, "--method hardware --bias 0.1");
    setting_print(fields, &setting, &defaults, text, 10);
    assert_string_equal(text, "--method ");
}

static void what_is_printed_restores_the_same_bits(void **state)
{
    (void)state;
    Random random = { 1 };
    for (int i = 0; i < 20000; i++) {
        double fraction = (double)(random_bits(&random) >> 11) * 0x1p-53;
        Setting setting = { .bias = i % 2 ? fraction : -fraction * 1e-6,
                            .method = random_int(&random, 0, 2),
                            .map = (uint32_t)random_int(&random, 16, 8192) };
        Setting read = defaults;
        char text[SETTING_MAX_TEXT];
        GpError error = { "" };
        setting_print(fields, &setting, &defaults, text, sizeof text);
        if (setting_parse(fields, &read, text, &error))
            fail_msg("%s: %s", text, error.text);
        expect_same(&read, setting.method, setting.map, setting.bias);
    }
}

static void numbers_are_as_short_as_they_can_be(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } expected[] = {
        { 0, "0" },
        { 0.1, "0.1" },
        { 1e300, "1e+300" },
        { -2.5, "-2.5" },
        { 0.1 + 0.2, "0.30000000000000004" },
        { 1.0 / 3, "0.3333333333333333" },
    };
    for (size_t i = 0; i < GP_COUNT(expected); i++) {
        char text[32];
        text_of_number(expected[i].value, text);
        assert_string_equal(text, expected[i].text);
    }
}

/* --- sweeps ----------------------------------------------------------------------------------- */

static void a_sweep_expands_to_all_combinations_the_last_list_fastest(void **state)
{
    (void)state;
    static const char *const expected[] = {
        "--method soft --map=16 --bias 0",   "--method soft --map=16 --bias .5",
        "--method soft --map=16 --bias 1",   "--method soft --map=256 --bias 0",
        "--method soft --map=256 --bias .5", "--method soft --map=256 --bias 1",
    };
    static const char sweep[] = " --method  soft --map=16|256 --bias 0|.5|1 ";
    char texts[8][SETTING_MAX_TEXT];
    memset(texts, '#', sizeof texts);
    assert_int_equal(technique_expand(sweep, NULL, 0), 6);
    assert_int_equal(technique_expand(sweep, texts, 6), 6);
    for (size_t i = 0; i < GP_COUNT(expected); i++)
        assert_string_equal(texts[i], expected[i]);
    assert_int_equal(texts[6][0], '#');
    assert_int_equal(technique_expand(sweep, texts + 6, 1), 6);
    assert_string_equal(texts[6], expected[0]);
    assert_int_equal(texts[7][0], '#');
}

static void a_sweep_without_lists_is_one_setting(void **state)
{
    (void)state;
    char text[1][SETTING_MAX_TEXT];
    assert_int_equal(technique_expand("", text, 1), 1);
    assert_string_equal(text[0], "");
    assert_int_equal(technique_expand("--map 32", text, 1), 1);
    assert_string_equal(text[0], "--map 32");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_text_sets_the_members_that_it_names),
        cmocka_unit_test(mistakes_are_told_with_what_was_expected_and_change_nothing),
        cmocka_unit_test(sizes_vectors_flags_and_texts_are_settings_too),
        cmocka_unit_test(other_types_tell_what_was_expected),
        cmocka_unit_test(only_members_that_differ_are_printed_in_the_tables_order),
        cmocka_unit_test(what_is_printed_restores_the_same_bits),
        cmocka_unit_test(numbers_are_as_short_as_they_can_be),
        cmocka_unit_test(a_sweep_expands_to_all_combinations_the_last_list_fastest),
        cmocka_unit_test(a_sweep_without_lists_is_one_setting),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
