/* Pictures and the page of charts: well formed whatever the names and metrics, and all in it. */
#include "apps/charts/chart_draw.h"
#include "apps/charts/chart_file.h"
#include "apps/charts/chart_layout.h"
#include "apps/charts/chart_page.h"
#include "tests/support/folder.h"
#include "tests/support/markup.h"

#include <math.h>

static const Technique *const no_techniques[] = { NULL };

static char page[1 << 20];

/* --- a chart ---------------------------------------------------------------------------------- */

static const char nasty[] = "<b> & \"c\" 'd' </title> \x01";

/* count points of some methods with nasty names; every seventh without any error, every eleventh
 * with one that is no number or beyond all bounds. */
static Chart make_chart(uint32_t count, uint32_t methods)
{
    Chart chart = { .technique = "t",
                    .isa = "i",
                    .metrics = { "" },
                    .metric_count = 1,
                    .threads = 1,
                    .width = 5,
                    .height = 4,
                    .count = count };
    snprintf(chart.title, sizeof chart.title, "%s", nasty);
    snprintf(chart.scene, sizeof chart.scene, "%s", nasty);
    snprintf(chart.machine, sizeof chart.machine, "%s", nasty);
    snprintf(chart.error_name, sizeof chart.error_name, "%s", nasty);
    snprintf(chart.metrics[0], sizeof chart.metrics[0], "%s", nasty);
    chart.points = gp_alloc(count, sizeof *chart.points);
    for (uint32_t i = 0; i < count; i++) {
        ChartPoint *point = &chart.points[i];
        snprintf(point->method, sizeof point->method, "%s %u", nasty, i % methods);
        snprintf(point->options, sizeof point->options, "--a %u --b %s", i, nasty);
        point->time.ms = pow(1.5, i % 13) * (1 + i * 0.01);
        point->measured.error = i % 7 == 6 ? 0 : pow(0.5, i % 17) * (1 + i * 0.03);
        if (i % 11 == 10)
            point->measured.error =
                ((const double[]){ (double)NAN, HUGE_VAL, 1e300, 1e-300 })[i / 11 % 4];
    }
    chart_mark_best(&chart);
    return chart;
}

static Text draw(const Chart *chart)
{
    Text svg = { .data = NULL };
    chart_draw(chart, &svg);
    assert_false(svg.failed);
    assert_int_equal(strlen(svg.data), svg.length);
    return svg;
}

static const PlotBox box = { 100, 50, 900, 650 };

/* --- pictures --------------------------------------------------------------------------------- */

static void pictures_are_well_formed_for_any_names_and_metrics(void **state)
{
    (void)state;
    static const uint32_t counts[][2] = { { 0, 1 }, { 1, 1 }, { 2, 1 }, { 60, 14 }, { 300, 40 } };
    for (size_t i = 0; i < GP_COUNT(counts); i++) {
        Chart chart = make_chart(counts[i][0], counts[i][1]);
        Text svg = draw(&chart);
        markup_check(svg.data);
        assert_null(strstr(svg.data, "<b>"));
        assert_null(strchr(svg.data, '\x01'));
        assert_null(strstr(svg.data, "nan"));
        assert_null(strstr(svg.data, "inf,"));
        assert_null(strstr(svg.data, "script"));
        assert_non_null(strstr(svg.data, "&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;"));
        text_free(&svg);
        chart_free(&chart);
    }
}

static void every_point_with_metrics_is_drawn_with_its_tooltip(void **state)
{
    (void)state;
    Chart chart = make_chart(60, 5);
    Text svg = draw(&chart);
    assert_int_equal(markup_count(svg.data, "<title>"), 1 + 55); /* the picture's own */
    assert_non_null(strstr(svg.data, "not shown: 5 that no axis can hold"));
    for (uint32_t i = 0; i < chart.count; i++) {
        char options[32];
        snprintf(options, sizeof options, "\n--a %u --b", i);
        assert_int_equal(markup_count(svg.data, options), i % 11 != 10);
    }
    text_free(&svg);
    chart_free(&chart);
}

/* By the pointer and by keys, for those whose label found no room, too. */
static void every_best_point_can_be_asked_for_its_numbers(void **state)
{
    (void)state;
    Chart chart = make_chart(60, 4);
    Plot plot;
    for (uint32_t i = 0; i < chart.count; i++) {
        chart.points[i].time.ms = 1 + 1e-3 * i; /* so near that labels find no room */
        chart.points[i].measured.error = 60 - i;
    }
    chart_mark_best(&chart);
    assert_int_equal(plot_create(&chart, box, &plot), GP_OK);
    Text svg = draw(&chart);
    assert_int_equal(plot.best_count, 60);
    assert_in_range(plot.label_count, 1, 59);
    assert_int_equal(markup_count(svg.data, "<g class=\"best\" tabindex=\"0\""), plot.best_count);
    assert_int_equal(markup_count(svg.data, "<g class=\"pane\">"), plot.best_count);
    text_free(&svg);
    plot_free(&plot);
    chart_free(&chart);
}

static void a_busy_machine_is_told(void **state)
{
    (void)state;
    static const struct {
        double others;
        int told;
    } rows[] = { { -1, 0 }, { 0, 0 }, { 0.05, 0 }, { 1.26, 1 } };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        Chart chart = make_chart(10, 2);
        chart.others = rows[i].others;
        Text svg = draw(&chart);
        assert_int_equal(markup_count(svg.data, "other programs kept 1.3 processors at work"),
                         rows[i].told);
        assert_int_equal(markup_count(svg.data, "The machine was busy"), rows[i].told);
        text_free(&svg);
        chart_free(&chart);
    }
}

static void a_page_of_equal_points_has_its_axes(void **state)
{
    (void)state;
    Chart chart = make_chart(3, 3);
    for (uint32_t i = 0; i < chart.count; i++) {
        chart.points[i].time.ms = 10;
        chart.points[i].measured.error = 200;
    }
    chart_mark_best(&chart);
    Text svg = draw(&chart);
    assert_non_null(strstr(svg.data, ">10<"));
    assert_non_null(strstr(svg.data, ">20<"));
    assert_non_null(strstr(svg.data, ">200<"));
    text_free(&svg);
    chart_free(&chart);
}

/* --- geometry --------------------------------------------------------------------------------- */

static void scales_are_logarithmic_and_hold_every_point(void **state)
{
    (void)state;
    Plot plot;
    Chart chart = make_chart(100, 7);
    assert_int_equal(plot_create(&chart, box, &plot), GP_OK);
    assert_int_equal(plot.count + plot.left_out, 100);
    assert_int_equal(plot.method_count, 7);
    assert_true(plot.has_zero);
    for (uint32_t i = 0; i < plot.count; i++) {
        const PlotPoint *point = &plot.points[i];
        assert_true(point->x > box.left && point->x < box.right);
        assert_true(point->y > box.top && point->y < box.bottom);
        bool zero = point->point->measured.error == 0;
        assert_int_equal(zero, point->y > plot.y.begin);
    }
    double step = plot_place(&plot.x, 20) - plot_place(&plot.x, 10);
    assert_true(step > 0);
    assert_true(fabs(plot_place(&plot.x, 6) - plot_place(&plot.x, 3) - step) < 1e-9);
    plot_free(&plot);
    chart_free(&chart);
}

static void ticks_rise_and_lie_between_the_ends(void **state)
{
    (void)state;
    const PlotScale scales[] = { { 0.9, 4.1, 0, 1, false },
                                 { 3, 200, 0, 1, false },
                                 { 1e-7, 1e9, 0, 1, false },
                                 { 50, 600, 0, 1, true } };
    static const int least_labelled[] = { 4, 6, 16, 4 };
    for (size_t i = 0; i < GP_COUNT(scales); i++) {
        double last = 0, tick = 0;
        int labels = 0;
        bool labelled;
        while ((tick = plot_next_tick(&scales[i], last, &labelled)) > 0) {
            assert_true(tick > last && tick >= scales[i].low && tick <= scales[i].high);
            labels += labelled;
            last = tick;
        }
        assert_in_range(labels, least_labelled[i], 20);
    }
}

static void labels_overlap_neither_each_other_nor_the_edge(void **state)
{
    (void)state;
    const double letter = 5;
    Plot plot;
    Chart chart = make_chart(200, 3);
    for (uint32_t i = 0; i < chart.count; i++) {
        ChartPoint *point = &chart.points[i];
        snprintf(point->options, sizeof point->options, "--map %u --same 1", i);
        point->time.ms = pow(1.1, i % 40) * (i < 40 ? 1 : 1.5);
        point->measured.error = 1e5 * pow(0.8, i % 40) * (1 + i / 40);
    }
    chart_mark_best(&chart);
    assert_int_equal(plot_create(&chart, box, &plot), GP_OK);
    assert_int_equal(plot.best_count, 40);
    assert_in_range(plot.label_count, 20, 40);
    for (uint32_t i = 0; i < plot.label_count; i++) {
        const PlotLabel *a = &plot.labels[i];
        double width = letter * (double)strlen(a->text), left = a->ends ? a->x - width : a->x;
        assert_true(left > box.left && left + width < box.right);
        const char *point = strstr(a->text, ": map ");
        assert_non_null(point);
        assert_null(strchr(point, ','));
        assert_true(strncmp(a->text, nasty, strlen(nasty)) == 0);
        for (uint32_t k = 0; k < i; k++) {
            const PlotLabel *b = &plot.labels[k];
            double other_width = letter * (double)strlen(b->text);
            double other = b->ends ? b->x - other_width : b->x;
            bool beside = left >= other + other_width || other >= left + width;
            assert_true(beside || fabs(a->y - b->y) >= 11);
        }
    }
    plot_free(&plot);
    chart_free(&chart);
}

/* The bar is from quartile to quartile, inside the axes, and no label lies on it. */
static void bars_are_the_middle_half_of_the_times(void **state)
{
    (void)state;
    Plot plot;
    Chart chart = make_chart(30, 3);
    for (uint32_t i = 0; i < chart.count; i++) {
        Timing *time = &chart.points[i].time;
        time->low_ms = 0.5 * time->ms;
        time->high_ms = i % 5 ? 4 * time->ms : 0;
    }
    int bars = 0;
    assert_int_equal(plot_create(&chart, box, &plot), GP_OK);
    for (uint32_t i = 0; i < plot.count; i++) {
        const PlotPoint *point = &plot.points[i];
        const bool has_bar = point->point->time.high_ms > 0;
        bars += has_bar;
        assert_true(point->left >= box.left && point->right <= box.right);
        assert_int_equal(point->left < point->x, has_bar);
        assert_int_equal(point->right > point->x, has_bar);
        for (uint32_t k = 0; k < plot.label_count; k++) {
            const PlotLabel *label = &plot.labels[k];
            const bool beside = label->ends ? label->x <= point->left : label->x >= point->right;
            const bool over = point->y > label->y - 9 && point->y < label->y + 2;
            const double width = 5 * (double)strlen(label->text);
            const double begin = label->ends ? label->x - width : label->x;
            assert_false(has_bar && over && !beside && begin < point->right &&
                         begin + width > point->left);
        }
    }
    Text svg = draw(&chart);
    assert_int_equal(markup_count(svg.data, "v6.0m0 -3.0H"), bars);
    text_free(&svg);
    plot_free(&plot);
    chart_free(&chart);
}

/* --- the page --------------------------------------------------------------------------------- */

static void write_chart(const char *name, const char *title, const char *picture)
{
    Chart chart = make_chart(20, 4);
    GpError error = { "" };
    snprintf(chart.title, sizeof chart.title, "%s", title);
    for (uint32_t i = 0; i < chart.count; i++)
        if (chart.points[i].best)
            snprintf(chart.points[i].picture, sizeof chart.points[i].picture, "%s", picture);
    /* JSON has escapes for control characters, so that the name comes back as it was. */
    if (chart_write(in_folder(name), &chart, &error))
        fail_msg("%s", error.text);
    chart_free(&chart);
}

static void the_page_holds_all_charts_and_nothing_from_elsewhere(void **state)
{
    (void)state;
    GpError error = { "" };
    write_chart("b", "Second & last", "");
    write_chart("a", "First", "");
    put_text("broken.json", "{\"technique\": <\"a\"");
    put_text("readme.txt", "not ours");
    assert_int_equal(chart_write_page(folder, no_techniques, &error), GP_OK);
    get_text("index.html", page, sizeof page);
    markup_check(page);
    assert_int_equal(markup_count(page, "<section"), 2);
    assert_int_equal(markup_count(page, "<svg"), 2);
    assert_int_equal(markup_count(page, "<table>"), 4);
    const char *first = strstr(page, "<h2>First"), *last = strstr(page, "<h2>Second &amp; last");
    assert_true(first && last && first < last);
    assert_non_null(strstr(page, "<a href=\"#b\">Second &amp; last ("));
    assert_non_null(strstr(page, "broken.json:1:"));
    assert_null(strstr(page, "script"));
    assert_null(strstr(page, "@import"));
    assert_int_equal(markup_count(page, "http"), 2); /* the SVGs' name space */
    assert_int_equal(markup_count(page, "http://www.w3.org/2000/svg"), 2);
}

static void a_page_without_charts_is_a_page(void **state)
{
    (void)state;
    GpError error = { "" };
    assert_int_equal(chart_write_page(folder, no_techniques, &error), GP_OK);
    get_text("index.html", page, sizeof page);
    markup_check(page);
    assert_int_equal(chart_write_page(in_folder("none"), no_techniques, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "none"));
}

/* The texts are RFC 4648's. */
static void pictures_are_in_the_page_as_base64(void **state)
{
    (void)state;
    static const char *const vectors[][2] = {
        { "", "" },
        { "f", "Zg==" },
        { "fo", "Zm8=" },
        { "foo", "Zm9v" },
        { "foob", "Zm9vYg==" },
        { "fooba", "Zm9vYmE=" },
        { "foobar", "Zm9vYmFy" },
        { "\xff\xfe\xfd", "//79" },
    };
    GpError error = { "" };
    write_chart("a", "First", "a_1.png");
    for (size_t i = 0; i < GP_COUNT(vectors); i++) {
        char expected[64];
        put_text("a_1.png", vectors[i][0]);
        assert_int_equal(chart_write_page(folder, no_techniques, &error), GP_OK);
        get_text("index.html", page, sizeof page);
        markup_check(page);
        snprintf(expected, sizeof expected, "src=\"data:image/png;base64,%s\"", vectors[i][1]);
        assert_true(markup_count(page, expected) > 0);
    }
}

static void pictures_that_are_missing_or_elsewhere_are_left_out(void **state)
{
    (void)state;
    GpError error = { "" };
    write_chart("a", "First", "missing.png");
    write_chart("b", "Second", "../b.png");
    put_text("c.png", "abc");
    assert_int_equal(chart_write_page(folder, no_techniques, &error), GP_OK);
    get_text("index.html", page, sizeof page);
    assert_int_equal(markup_count(page, "<section"), 2);
    assert_int_equal(markup_count(page, "<img"), 0);
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_well_formed_for_any_names_and_metrics),
        cmocka_unit_test(every_point_with_metrics_is_drawn_with_its_tooltip),
        cmocka_unit_test(every_best_point_can_be_asked_for_its_numbers),
        cmocka_unit_test(a_busy_machine_is_told),
        cmocka_unit_test(a_page_of_equal_points_has_its_axes),
        cmocka_unit_test(scales_are_logarithmic_and_hold_every_point),
        cmocka_unit_test(ticks_rise_and_lie_between_the_ends),
        cmocka_unit_test(bars_are_the_middle_half_of_the_times),
        cmocka_unit_test(labels_overlap_neither_each_other_nor_the_edge),
        IN_FOLDER(the_page_holds_all_charts_and_nothing_from_elsewhere),
        IN_FOLDER(a_page_without_charts_is_a_page),
        IN_FOLDER(pictures_are_in_the_page_as_base64),
        IN_FOLDER(pictures_that_are_missing_or_elsewhere_are_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
