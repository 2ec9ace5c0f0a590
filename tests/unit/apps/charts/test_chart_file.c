/* Files of charts: JSON that restores every bit and refuses what is none, CSV with its quotes. */
#include "apps/charts/chart_file.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

#include <math.h>

/* --- writing ---------------------------------------------------------------------------------- */

static double random_double(Random *random)
{
    union {
        uint64_t bits;
        double value;
    } any = { .bits = random_bits(random) };
    return any.value;
}

static void expect_same_bits(double a, double b)
{
    if (!isnan(a) || !isnan(b))
        assert_memory_equal(&a, &b, sizeof a);
}

/* Doubles of any size, infinities and texts with every special character. */
static void json_restores_every_bit(void **state)
{
    (void)state;
    Random random = { 3 };
    GpError error = { "" };
    Chart read = { .points = NULL };
    Chart chart = { .technique = "light",
                    .title = "a \"b\" \\ <c> & \xc3\xa9\n",
                    .scene = "/",
                    .error_name = "e",
                    .metrics = { "x", "" },
                    .metric_count = 2,
                    .machine = "m",
                    .isa = "i",
                    .threads = 3,
                    .others = 0.1,
                    .width = 4294967295,
                    .height = 1,
                    .count = 300 };
    chart.points = gp_alloc(chart.count, sizeof *chart.points);
    for (uint32_t i = 0; i < chart.count; i++) {
        ChartPoint *point = &chart.points[i];
        snprintf(point->method, sizeof point->method, "m, %u", i % 7);
        snprintf(point->options, sizeof point->options, "--n \"%u\"", i);
        snprintf(point->picture, sizeof point->picture, "%s", i % 2 ? "p.png" : "");
        point->time.ms = random_double(&random);
        point->time.min_ms = i % 3 ? random_double(&random) : -HUGE_VAL;
        point->time.cpu_ms = i % 5 ? i : (double)NAN;
        point->measured.error = i % 4 ? random_double(&random) : HUGE_VAL;
        point->measured.metrics[0] = i % 2 ? -0.0 : 0.1;
        point->measured.metrics[1] = random_double(&random);
        point->time.frames = (uint32_t)random_bits(&random);
        point->best = i % 2;
    }
    if (chart_write(in_folder("c"), &chart, &error) ||
        chart_read(in_folder("c.json"), &read, &error))
        fail_msg("%s", error.text);
    assert_int_equal(folder_count(false), 3);
    assert_string_equal(read.title, chart.title);
    assert_string_equal(read.scene, chart.scene);
    assert_string_equal(read.metrics[0], "x");
    assert_int_equal(read.metric_count, 2);
    assert_int_equal(read.threads, 3);
    expect_same_bits(read.others, chart.others);
    assert_int_equal(read.width, 4294967295);
    assert_int_equal(read.count, chart.count);
    for (uint32_t i = 0; i < chart.count; i++) {
        const ChartPoint *a = &chart.points[i], *b = &read.points[i];
        assert_string_equal(a->method, b->method);
        assert_string_equal(a->options, b->options);
        assert_string_equal(a->picture, b->picture);
        expect_same_bits(a->time.ms, b->time.ms);
        expect_same_bits(a->time.min_ms, b->time.min_ms);
        expect_same_bits(a->time.cpu_ms, b->time.cpu_ms);
        expect_same_bits(a->measured.error, b->measured.error);
        expect_same_bits(a->measured.metrics[0], b->measured.metrics[0]);
        expect_same_bits(a->measured.metrics[1], b->measured.metrics[1]);
        assert_int_equal(a->time.frames, b->time.frames);
        assert_int_equal(a->best, b->best);
    }
    chart_free(&chart);
    chart_free(&read);
}

static void csv_quotes_what_needs_it(void **state)
{
    (void)state;
    ChartPoint points[] = {
        { .method = "a, b",
          .options = "--c \"d\"",
          .time.ms = 0.1,
          .time.min_ms = 0.5,
          .time.cpu_ms = 2,
          .time.low_ms = 0.25,
          .time.frames = 7,
          .measured = { .error = 1e-300, .metrics = { 3, (double)NAN } },
          .best = true },
        { .method = "plain", .options = "--two\nlines --c 3 --cc=4", .time.ms = 1.0 / 3 },
    };
    const Chart chart = { .error_name = "wrong, pixels",
                          .metrics = { "x", "y" },
                          .metric_count = 2,
                          .points = points,
                          .count = 2 };
    GpError error = { "" };
    char text[1024];
    assert_int_equal(chart_write(in_folder("c"), &chart, &error), GP_OK);
    get_text("c.csv", text, sizeof text);
    assert_string_equal(
        text, "method,options,--c,\"--two\nlines\",--cc,ms,min_ms,low_ms,high_ms,max_ms,cpu_ms,"
              "frames,\"wrong, pixels\",x,y,best\n"
              "\"a, b\",\"--c \"\"d\"\"\",\"\"\"d\"\"\",,,0.1,0.5,0.25,0,0,2,7,"
              "1e-300,3,nan,1\n"
              "plain,\"--two\nlines --c 3 --cc=4\",3,1,4,0.3333333333333333,0,0,0,0,0,0,"
              "0,0,0,0\n");
}

static void a_chart_that_cannot_be_written_is_an_error(void **state)
{
    (void)state;
    const Chart chart = { .title = "t" };
    GpError error = { "" };
    assert_int_equal(chart_write(in_folder("no/where"), &chart, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "no/where.csv"));
}

/* --- reading ---------------------------------------------------------------------------------- */

/* The good text with one part replaced is refused with this message behind "FILE:"; NULL: it is
 * read. */
typedef struct Refusal {
    const char *part, *by, *expected;
} Refusal;

static bool is_refused(const Refusal *row)
{
    static const char good[] =
        "{\"technique\": \"t\", \"title\": \"t\", \"scene\": \"s\", \"error_name\": \"e\",\n"
        " \"metrics\": [\"f\"], \"machine\": \"m\", \"isa\": \"i\", \"threads\": 1, \"width\": 2,\n"
        " \"height\": 3, \"points\": [\n"
        "  {\"method\": \"m\", \"options\": \"o\", \"picture\": \"\", \"ms\": 1, \"min_ms\": 1,\n"
        "   \"cpu_ms\": 1.5, \"frames\": 5, \"error\": \"nan\", \"metrics\": [7], \"best\": "
        "true}]}\n";
    char text[2 * sizeof good + 256];
    const char *place = strstr(good, row->part);
    assert_non_null(place);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(place - good), good, row->by,
             place + strlen(row->part));
    Chart chart = { .count = 77 };
    GpError error = { "" };
    const char *path = put_text("c.json", text);
    GpResult result = chart_read(path, &chart, &error);
    if (!row->expected) {
        const bool whole = !result && chart.count == 1;
        if (!result)
            chart_free(&chart);
        return whole;
    }
    const size_t length = strlen(path);
    if (result == GP_ERROR_FORMAT && chart.count == 77 && !chart.points &&
        strncmp(error.text, path, length) == 0 &&
        strcmp(error.text + length + 1, row->expected) == 0)
        return true;
    print_error("'%s' instead of '%s'\n", error.text, row->expected);
    return false;
}

static void files_that_are_no_charts_are_refused_with_their_line(void **state)
{
    (void)state;
    char long_text[128];
    memset(long_text, 'x', sizeof long_text);
    memcpy(long_text, "\"method\": \"", 11);
    strcpy(long_text + sizeof long_text - 2, "\"");
    const Refusal rows[] = {
        { "\"t\"", "\"t\"", NULL },
        { "\"title\": \"t\", ", "", "1: title: missing" },
        { "\"s\"", "3", "1: scene: expected a string" },
        { "[\"f\"]", "[]", "5: points[0].metrics: expected 0 numbers" },
        { "[\"f\"]", "[2]", "2: metrics[0]: expected a string" },
        { "\"threads\": 1", "\"threads\": -1",
          "2: threads: expected a whole number in [0, 2147483647]" },
        { "\"height\": 3", "\"height\": 3, \"depth\": 4", "3: depth: unknown key" },
        { "\"method\": \"m\"", long_text, "4: points[0].method: expected at most 63 bytes" },
        { "\"ms\": 1,", "", "4: points[0].ms: missing" },
        { "\"nan\"", "\"none\"", "5: points[0].error: expected one of nan, inf, -inf" },
        { "\"nan\"", "null", "5: points[0].error: expected a number in [-inf, inf]" },
        { "[7]", "7", "5: points[0].metrics: expected an array" },
        { "[7]", "[7, 8]", "5: points[0].metrics: expected 1 numbers" },
        { "\"frames\": 5", "\"frames\": 5.5",
          "5: points[0].frames: expected a whole number in [0, 4294967295]" },
        { "true", "1", "5: points[0].best: expected true or false" },
        { ", \"best\": true", "", "4: points[0].best: missing" },
        { "}]}", "}, 4]}", "5: points[1]: expected an object" },
    };
    size_t refused = 0;
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        refused += is_refused(&rows[i]);
    assert_int_equal(refused, GP_COUNT(rows));
    Chart chart = { .count = 77 };
    GpError error = { "" };
    assert_int_equal(chart_read(put_text("e.json", ""), &chart, &error), GP_ERROR_FORMAT);
    assert_int_equal(chart_read(put_text("e.json", "[]"), &chart, &error), GP_ERROR_FORMAT);
    assert_int_equal(chart_read(put_text("e.json", "{\"a\""), &chart, &error), GP_ERROR_FORMAT);
    assert_int_equal(chart_read(in_folder("none.json"), &chart, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "none.json"));
    assert_int_equal(chart.count, 77);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(json_restores_every_bit),
        IN_FOLDER(csv_quotes_what_needs_it),
        IN_FOLDER(a_chart_that_cannot_be_written_is_an_error),
        IN_FOLDER(files_that_are_no_charts_are_refused_with_their_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
