/* From a scene to the setting that a chart chooses for it: chart, --error, and bench beside them,
 * on a scene so small that times mean nothing and errors do. */
#include "apps/frame/picture.h"
#include "pipeline/base/base.h"
#include "tests/support/program.h"

static const char small[] =
    "{ \"size\": [64, 48], \"lights\": [ { \"direction\": [1, -2, -1] } ],\n"
    "  \"camera\": { \"eye\": [2, 1.5, 3], \"at\": [0, 0, 0], \"fovy\": 40 },\n"
    "  \"objects\": [ { \"mesh\": \"builtin:plane\" },\n"
    "                 { \"mesh\": \"builtin:cube\", \"fit\": [0, 0, 0, 1] } ] }\n";

static const char lit[] =
    "{ \"size\": [64, 48], \"lights\": [ { \"direction\": [1, 2, 1] } ],\n"
    "  \"camera\": { \"eye\": [2, 1.5, 3], \"at\": [0, 0, 0], \"fovy\": 40 },\n"
    "  \"objects\": [ { \"mesh\": \"builtin:plane\" },\n"
    "                 { \"mesh\": \"builtin:cube\", \"fit\": [0, 0.5, 0, 1] } ] }\n";

static double number(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    if (!json_is_number(value))
        fail_msg("%s is no number", key);
    return json_number_value(value);
}

static const char *text(const json_t *object, const char *key)
{
    const char *value = json_string_value(json_object_get(object, key));
    if (value)
        return value;
    fail_msg("%s is no text", key);
    return "";
}

/* The options of the point that was chosen, whose error is at most that. Which of several is a
 * matter of times, and of test_chart. */
static const char *chosen(const json_t *points, double most)
{
    size_t i;
    json_t *point;
    json_array_foreach(points, i, point)
    {
        char words[256];
        snprintf(words, sizeof words, "chose %s (", text(point, "options"));
        if (!strstr(err, words))
            continue;
        assert_true(number(point, "error") <= most);
        return text(point, "options");
    }
    fail_msg("no point of the chart was chosen: %s", err);
    return NULL;
}

static void a_chart_chooses_the_setting_that_is_drawn(void **state)
{
    (void)state;
    static const double errors[] = { 0, 5, 1000 };
    write_file("small.json", small);
    assert_int_equal(shell("glasspipe chart shadow small.json -t 0 -o charts -q --json"), 0);
    json_t *chart = parse_output(), *points = json_object_get(chart, "points");
    assert_true(json_array_size(points) >= 50);
    assert_string_equal(text(chart, "scene"), "small.json");
    json_t *stored = json_load_file("charts/shadow_small.json", 0, NULL);
    assert_int_equal(json_array_size(json_object_get(stored, "points")), json_array_size(points));
    json_decref(stored);
    for (size_t i = 0; i < GP_COUNT(errors); i++) {
        assert_int_equal(shell("glasspipe shadow small.json --error %g "
                               "--curve charts/shadow_small.json --trust-chart -o b.ppm",
                               errors[i]),
                         0);
        static char drawn[sizeof out];
        strcpy(drawn, out);
        const char *options = chosen(points, errors[i]);
        assert_int_equal(shell("glasspipe shadow small.json -q -o a.ppm %s", options), 0);
        assert_string_equal(out, drawn);
        assert_int_equal(shell("glasspipe shadow small.json --error %g "
                               "--curve charts/shadow_small.json -o c.ppm",
                               errors[i]),
                         0);
        chosen(points, errors[i]);
        expect_contains(err, "looked at ");
    }
    json_decref(chart);
    static char page[1 << 18];
    read_file("charts/index.html", page, sizeof page);
    expect_contains(page, "wrong pixels");
    assert_int_equal(access("charts/shadow_small.svg", R_OK), 0);
    assert_int_equal(access("charts/shadow_small.csv", R_OK), 0);
}

/* A chart of one setting that claims no error at all. */
static void write_liar(void)
{
    write_file("small.json", small);
    write_file(
        "chart.json",
        "{ \"technique\": \"shadow\", \"scene\": \"small.json\", \"error_name\": \"wrong pixels\","
        " \"title\": \"t\", \"metrics\": [], \"machine\": \"m\", \"isa\": \"i\", \"threads\": 1,"
        " \"width\": 64, \"height\": 48, \"points\": [ { \"method\": \"m\", \"options\": "
        "\"--map 16 --filter nearest --bias 0.5\", \"ms\": 1, \"min_ms\": 1, \"cpu_ms\": 1, "
        "\"frames\": 1, \"error\": 0, \"metrics\": [], \"best\": true, \"picture\": \"\" } ] }\n");
}

static void a_chart_is_believed_only_where_that_is_asked_for(void **state)
{
    (void)state;
    write_liar();
    assert_int_equal(
        shell("glasspipe shadow small.json --error 7 --curve chart.json --trust-chart -o a.ppm"),
        0);
    expect_contains(err, "--map 16");
    expect_contains(err, "error 0 (expected, from another scene) wrong pixels");
    char honest[1024];
    read_file("chart.json", honest, sizeof honest);
    char *error = strstr(honest, "\"error\": 0");
    assert_non_null(error);
    error[strlen("\"error\": ")] = '9';
    write_file("honest.json", honest);
    assert_int_equal(
        shell("glasspipe shadow small.json --error 7 --curve honest.json --trust-chart "
              "-o b.ppm --json"),
        1);
    expect_contains(err, "glasspipe: not reached: the most exact of honest.json, --map 16 ");
    expect_contains(err, "has error 9 (expected, from another scene) wrong pixels");
    json_t *object = parse_output();
    assert_true(json_is_false(json_object_get(json_object_get(object, "error"), "reached")));
    json_decref(object);
    assert_int_equal(shell("glasspipe compare a.ppm b.ppm"), 0);
    assert_int_equal(shell("glasspipe shadow small.json --error 7 --curve chart.json -o a.ppm"), 0);
    assert_null(strstr(err, "chose --map 16"));
    expect_matches(err, "chose .*: error [0-7] \\(measured\\) wrong pixels");
    assert_int_equal(shell("glasspipe shadow small.json --error 7 --curve chart.json -o a.ppm"), 0);
    expect_matches(err, "looked at ([0-9]+) settings?, \\1 of them remembered");
    assert_int_equal(shell("ls measured | wc -l"), 0);
    assert_string_equal(out, "1\n");
}

/* The scene is as wide as a texel: the truth has edges that no map of the sweep can show. */
static void an_error_that_no_setting_reaches_is_said_and_the_best_is_drawn(void **state)
{
    (void)state;
    static const char thin[] =
        "{ \"size\": [64, 48], \"lights\": [ { \"position\": [2, 3, 1], \"at\": [0, 0, 0], "
        "\"size\": 2 } ],\n"
        "  \"camera\": { \"eye\": [2, 1.5, 3], \"at\": [0, 0, 0], \"fovy\": 40 },\n"
        "  \"objects\": [ { \"mesh\": \"builtin:plane\" },\n"
        "                 { \"mesh\": \"builtin:knot\", \"fit\": [0, 0.5, 0, 1] } ] }\n";
    write_file("thin.json", thin);
    assert_int_equal(shell("glasspipe shadow -q thin.json --error 0 -o a.ppm --json"), 1);
    expect_matches(err, "^glasspipe: not reached: the most exact of all [0-9]+ settings, --.* "
                        "\\(.*\\), has error [0-9]+ \\(measured\\) wrong pixels");
    json_t *object = parse_output(), *told = json_object_get(object, "error");
    assert_true(json_is_false(json_object_get(told, "reached")));
    assert_true(number(told, "error") > 0);
    assert_int_equal(access("a.ppm", R_OK), 0);
    json_decref(object);
}

/* All combinations of what is named, under a name that leaves the technique's own chart alone. */
static void a_chart_of_ones_own_sweeps_what_is_named(void **state)
{
    (void)state;
    static const struct {
        const char *method, *options;
    } expected[] = {
        { "plain", "--method plain --map 32 --bias 0.001" },
        { "plain", "--method plain --map 32 --bias 0.01" },
        { "plain", "--method plain --map 64 --bias 0.001" },
        { "plain", "--method plain --map 64 --bias 0.01" },
        { "hardware", "--method hardware --map 32 --bias 0.001" },
        { "hardware", "--method hardware --map 32 --bias 0.01" },
        { "hardware", "--method hardware --map 64 --bias 0.001" },
        { "hardware", "--method hardware --map 64 --bias 0.01" },
    };
    static char file[1 << 16];
    write_file("lit.json", lit);
    assert_int_equal(shell("glasspipe chart shadow lit.json --bias 0.001,0.01 --map 32,64 "
                           "--method plain,hardware -t 0 -o charts -q --json"),
                     0);
    json_t *chart = parse_output(), *points = json_object_get(chart, "points");
    assert_int_equal(json_array_size(points), GP_COUNT(expected));
    for (size_t i = 0; i < GP_COUNT(expected); i++) {
        const json_t *point = json_array_get(points, i);
        assert_string_equal(text(point, "method"), expected[i].method);
        assert_string_equal(text(point, "options"), expected[i].options);
        assert_true(number(point, "min_ms") <= number(point, "low_ms"));
        assert_true(number(point, "low_ms") <= number(point, "ms"));
        assert_true(number(point, "ms") <= number(point, "high_ms"));
        assert_true(number(point, "high_ms") <= number(point, "max_ms"));
    }
    json_decref(chart);
    assert_int_equal(shell("ls charts"), 0);
    expect_matches(out, "^index.html\nshadow_lit_own.csv\nshadow_lit_own.json\nshadow_lit_own.svg\n"
                        "shadow_lit_own_1.png\n");
    read_file("charts/shadow_lit_own.csv", file, sizeof file);
    expect_contains(file, "method,options,--method,--map,--bias,ms,min_ms,low_ms,high_ms,max_ms,");
    expect_contains(file, "hardware,--method hardware --map 64 --bias 0.01,hardware,64,0.01,");
    read_file("charts/shadow_lit_own.svg", file, sizeof file);
    expect_matches(file, ">(plain|hardware): map (32|64), bias 0.01?");
}

/* Times of other conditions are others. The second setting takes longer than it may. */
static void a_journal_is_of_the_same_measurements(void **state)
{
    (void)state;
    static const char line[] = "chart shadow small.json --map 16,8192 --method plain -o charts "
                               "--executor reference -t 0 --timeout 1 --resume";
    static const char *const others[] = { "-t 0.1", "--executor fast", "--isa sse2" };
    write_file("small.json", small);
    assert_int_equal(shell("glasspipe %s", line), 4);
    expect_contains(err, "--map 8192: thread 1 has not drawn it in 1 s");
    for (size_t i = 0; i < GP_COUNT(others); i++) {
        const int code = shell("glasspipe %s %s", line, others[i]);
        if (code == 2 && strstr(err, "isa"))
            continue; /* this machine has none */
        assert_int_equal(code, 3);
        expect_contains(err, "glasspipe-chart.journal: of other work");
    }
    assert_int_equal(shell("glasspipe %s", line), 4);
}

static void charts_that_cannot_be_written_are_told_so(void **state)
{
    (void)state;
    static const char line[] = "chart shadow small.json --map 16 --method plain -t 0";
    char long_name[256];
    write_file("small.json", small);
    write_file("file", "");
    assert_int_equal(shell("glasspipe %s -o file", line), 4);
    expect_contains(err, "file: Not a directory");
    assert_int_equal(shell("glasspipe %s -o no/where", line), 4);
    expect_contains(err, "no/where: No such file or directory");
    assert_int_equal(
        shell("mkdir -p charts/shadow_small_own_1.png && glasspipe %s -o charts", line), 4);
    expect_contains(err, "charts/shadow_small_own_1.png: ");
    snprintf(long_name, sizeof long_name, "%s --name %064d", line, 0);
    expect_refused(2, long_name, "--name: expected at most 63 bytes");
    assert_int_equal(shell("glasspipe bench clear -t 0 --images file"), 4);
    expect_contains(err, "file: Not a directory");
    assert_int_equal(shell("glasspipe test . --report file"), 4);
    expect_contains(err, "file: Not a directory");
}

static void lists_of_volumes_and_their_names(void **state)
{
    (void)state;
    assert_int_equal(
        shell("glasspipe chart solids builtin:cube -n 8,16 -t 0 -o . --name figure -q --json"), 0);
    json_t *chart = parse_output(), *points = json_object_get(chart, "points");
    assert_int_equal(json_array_size(points), 2);
    assert_string_equal(text(json_array_get(points, 1), "options"), "--kind solid --size 16");
    assert_string_equal(text(json_array_get(points, 1), "method"), "solids");
    json_decref(chart);
    assert_int_equal(access("figure.svg", R_OK) | access("figure.json", R_OK), 0);
    expect_refused(2, "chart shadow --map 512,x",
                   "expected a whole number from 16 to 8192, not 'x'");
    expect_refused(2, "chart shadow --map 512,", "not ''");
    expect_refused(2, "chart shadow --method plain,soft", "expected plain or hardware, not 'soft'");
    expect_refused(2, "chart voxelize --map 5", "map");
    expect_refused(2, "chart shadow --name a/b", "--name: expected a name without '/'");
    expect_refused(2, "chart voxelize --scaling -n 8", "names and settings of its own");
    expect_refused(2, "chart voxelize --scaling --name a", "names and settings of its own");
}

/* What the light reaches, beside the truth: white, black, and nothing between on a plain map. */
static void visibility_is_written_and_read_back(void **state)
{
    (void)state;
    static const struct {
        const char *file;
        int channels;
    } files[] = { { "v.png", 1 }, { "v.exr", 1 }, { "v.pfm", 1 }, { "a.exr", 4 } };
    Picture pictures[GP_COUNT(files)] = { { 0 } };
    write_file("lit.json", lit);
    assert_int_equal(shell("glasspipe shadow lit.json --filter nearest -o a.exr "
                           "--output-visibility v.png --json"),
                     0);
    json_t *object = parse_output();
    assert_string_equal(text(object, "visibility"), "v.png");
    json_decref(object);
    assert_int_equal(
        shell("glasspipe shadow lit.json --filter nearest --output-visibility v.exr && "
              "glasspipe shadow lit.json --filter nearest --output-visibility v.pfm"),
        0);
    size_t bright = 0, dark = 0;
    for (size_t k = 0; k < GP_COUNT(files); k++) {
        assert_int_equal(picture_read(files[k].file, &pictures[k], NULL), GP_OK);
        assert_int_equal(pictures[k].channels, files[k].channels);
    }
    for (size_t i = 0; i < 64 * 48; i++) {
        const float seen = pictures[0].values[i];
        assert_true(seen == 0 || seen == 1);
        assert_true(pictures[1].values[i] == seen && pictures[2].values[i] == seen);
        assert_true(pictures[3].values[4 * i + 3] == seen);
        bright += seen > 0;
        dark += seen == 0;
    }
    assert_true(bright > 300 && dark > 300);
    for (size_t k = 0; k < GP_COUNT(files); k++)
        picture_free(&pictures[k]);
}

static void visibility_is_of_one_light(void **state)
{
    (void)state;
    static const char two[] =
        "{ \"lights\": [ { \"direction\": [1, 2, 1] }, { \"direction\": [0, 2, 1] } ],\n"
        "  \"objects\": [ { \"mesh\": \"builtin:cube\" } ] }\n";
    write_file("two.json", two);
    expect_refused(3, "shadow two.json --output-visibility v.png", "the scene has 2");
    expect_refused(2, "shadow two.json --output-visibility v.gif", "--output-visibility v.gif");
    expect_refused(2, "voxelize builtin:cube --output-visibility v.png", "output-visibility");
    Picture picture;
    assert_int_equal(shell("glasspipe shadow two.json --size 8x8 -o a.exr"), 0);
    assert_int_equal(picture_read("a.exr", &picture, NULL), GP_OK);
    assert_int_equal(picture.channels, 3);
    picture_free(&picture);
}

/* The setting that is told, given as options, draws the same picture; what was chosen is in it. */
static void json_names_every_value_that_was_used(void **state)
{
    (void)state;
    static const char *const given[] = { "", "--method plain", "--method plain --map 64 --fit eye",
                                         "--normal-offset 1 --depth d16",
                                         "--fit adaptive --map 64" };
    static const char *const named[] = { "--method ", "--filter ", "--map ",     "--depth ",
                                         "--bias ",   "--slope ",  "--casters ", "--fit ",
                                         "--facing ", "--outside " };
    write_file("lit.json", lit);
    for (size_t i = 0; i < GP_COUNT(given); i++) {
        char setting[512], hash[32];
        assert_int_equal(shell("glasspipe shadow lit.json -q -o a.ppm --json %s", given[i]), 0);
        json_t *object = parse_output();
        snprintf(setting, sizeof setting, "%s", text(object, "setting"));
        snprintf(hash, sizeof hash, "%s", text(object, "hash"));
        json_decref(object);
        for (size_t k = 0; k < GP_COUNT(named); k++)
            expect_contains(setting, named[k]);
        assert_null(strstr(setting, "auto"));
        assert_int_equal(shell("glasspipe shadow lit.json -q -o a.ppm %s", setting), 0);
        expect_contains(out, hash);
    }
    assert_int_equal(shell("glasspipe voxelize builtin:ball -q -n 16 -o a.bits --json"), 0);
    json_t *object = parse_output();
    expect_contains(text(object, "setting"), "--size 16 --kind surface --method conservative");
    json_decref(object);
}

/* What bench draws is what it writes, by either executor. */
static void a_case_of_bench_is_one_picture(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe bench -q -t 0 small_draws --images one"), 0);
    json_t *fast = parse_output();
    assert_int_equal(
        shell("glasspipe bench -q -t 0 small_draws --executor reference --images other"), 0);
    json_t *reference = parse_output();
    assert_string_equal(text(fast, "hash"), text(reference, "hash"));
    assert_true(number(fast, "frames") >= 1 && number(fast, "ms") > 0);
    assert_int_equal(shell("glasspipe compare one/small_draws.png other/small_draws.png"), 0);
    expect_contains(out, "same bits");
    json_decref(fast);
    json_decref(reference);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_chart_chooses_the_setting_that_is_drawn),
        PROGRAM_TEST(a_chart_is_believed_only_where_that_is_asked_for),
        PROGRAM_TEST(an_error_that_no_setting_reaches_is_said_and_the_best_is_drawn),
        PROGRAM_TEST(a_chart_of_ones_own_sweeps_what_is_named),
        PROGRAM_TEST(a_journal_is_of_the_same_measurements),
        PROGRAM_TEST(charts_that_cannot_be_written_are_told_so),
        PROGRAM_TEST(lists_of_volumes_and_their_names),
        PROGRAM_TEST(visibility_is_written_and_read_back),
        PROGRAM_TEST(visibility_is_of_one_light),
        PROGRAM_TEST(json_names_every_value_that_was_used),
        PROGRAM_TEST(a_case_of_bench_is_one_picture),
    };
    return cmocka_run_group_tests_name("charts", tests, find_program, NULL);
}
