#include "tests/peer/bench/peer_chart.h"

#include "apps/charts/plot.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 1200, LEGEND = 118, TOP = 160, LEFT = 520, RIGHT = 1040, PITCH = 24, GAP = 16 };

static const char soft[] = " fill=\"#5b6472\"";
static const char met[] = "#2a9d8f", missed[] = "#e76f51", without_target[] = "#9aa5b1";

typedef struct Row {
    const char *name, *about;
    double ratio, target; /* how many times faster; 0: none */
    double theirs, ours;  /* milliseconds; 0: the mean's */
} Row;

/* Three digits, as a number is read. */
static const char *short_number(double x, char text[32])
{
    snprintf(text, 32, x >= 100 ? "%.0f" : x >= 10 ? "%.1f" : "%.2f", x);
    return text;
}

static bool read_row(json_t *object, Row *row)
{
    json_t *target;
    *row = (Row){ .theirs = 0 };
    if (json_unpack(object, "{s:s, s:F, s:o, s:s, s?{s:F}, s?{s:F}}", "case", &row->name, "ratio",
                    &row->ratio, "target", &target, "about", &row->about, "llvmpipe", "ms",
                    &row->theirs, "glasspipe", "ms", &row->ours))
        return false;
    row->target = json_number_value(target);
    return row->ratio > 0;
}

/* All bars and targets, and always 1/2 to 16. */
static void widen(PlotScale *scale, double value)
{
    while (value > 0 && value < scale->low * 1.05)
        scale->low /= 2;
    while (value > scale->high / 1.05)
        scale->high *= 2;
}

static void draw_axis(const PlotScale *scale, double bottom, Text *svg)
{
    bool labelled;
    for (double tick = 0; (tick = plot_next_tick(scale, tick, &labelled)) > 0;) {
        const double x = plot_place(scale, tick);
        char name[32];
        snprintf(name, sizeof name, tick < 1 ? "1/%g" : "%gx", tick < 1 ? 1 / tick : tick);
        svg_line(svg, x, TOP - 6, x, bottom, tick == 1 ? svg_soft : svg_grid);
        svg_words(svg, x, TOP - 12, "middle", soft, name);
    }
    svg_words(svg, LEFT, bottom + 22, "start", soft,
              "Left of the line at 1x llvmpipe is faster. On the right: milliseconds a frame, "
              "llvmpipe / glasspipe.");
}

static void draw_target(double x, double y, double height, Text *svg)
{
    svg_rectangle(svg, x - 1.25, y, 2.5, height, svg_ink, "none");
}

static void draw_legend(Text *svg)
{
    static const struct {
        int x;
        const char *color, *text;
    } entries[] = { { 32, met, "target met" },
                    { 132, missed, "target missed" },
                    { 252, without_target, "no target" } };
    for (size_t i = 0; i < GP_COUNT(entries); i++) {
        svg_rectangle(svg, entries[i].x, LEGEND - 10, 14, 12, entries[i].color, "none");
        svg_words(svg, entries[i].x + 20, LEGEND, "start", soft, entries[i].text);
    }
    draw_target(353, LEGEND - 11, 14, svg);
    svg_words(svg, 362, LEGEND, "start", soft, "target: at least so many times as fast");
}

static void draw_row(const PlotScale *scale, const Row *row, double y, Text *svg)
{
    const bool mean = strcmp(row->name, "mean") == 0;
    const char *style = mean ? svg_bold : " font-size=\"13\"";
    const char *color = row->target == 0            ? without_target
                        : row->ratio >= row->target ? met
                                                    : missed;
    const double one = plot_place(scale, 1), end = plot_place(scale, row->ratio);
    char note[80], first[32], second[32];
    svg_rectangle(svg, end < one ? end : one, y + 4, end < one ? one - end : end - one, PITCH - 8,
                  color, "none");
    if (row->target > 0)
        draw_target(plot_place(scale, row->target), y + 2, PITCH - 4, svg);
    svg_words(svg, LEFT - 12, y + PITCH - 8, "end", style, mean ? "geometric mean" : row->name);
    svg_words(svg, PLOT_MARGIN, y + PITCH - 8, "start", soft, mean ? "" : row->about);
    snprintf(note, sizeof note, "%sx", short_number(row->ratio, first));
    svg_words(svg, RIGHT + 14, y + PITCH - 8, "start", style, note);
    snprintf(note, sizeof note, "%s / %s", short_number(row->theirs, first),
             short_number(row->ours, second));
    svg_words(svg, RIGHT + 70, y + PITCH - 8, "start", soft, mean ? "" : note);
}

static void draw_rows(const Row *rows, size_t count, Text *svg)
{
    PlotScale scale = { 0.5, 16, LEFT, RIGHT, .doubles = true };
    for (size_t i = 0; i < count; i++) {
        widen(&scale, rows[i].ratio);
        widen(&scale, rows[i].target);
    }
    draw_axis(&scale, TOP + (double)count * PITCH + GAP, svg);
    for (size_t i = 0; i < count; i++)
        draw_row(&scale, &rows[i], TOP + (double)i * PITCH + (i + 1 < count ? 0 : GAP / 2), svg);
}

static GpResult draw(json_t *root, Text *svg)
{
    static const char title[] =
        "glasspipe against llvmpipe: how many times faster it draws a frame";
    const char *date, *machine, *version, *peer;
    json_t *cases, *mean;
    int threads, rounds;
    if (json_unpack(root, "{s:s, s:s, s:s, s:s, s:i, s:i, s:o, s:o}", "date", &date, "machine",
                    &machine, "glasspipe", &version, "llvmpipe", &peer, "threads", &threads,
                    "rounds", &rounds, "cases", &cases, "mean", &mean))
        return GP_ERROR_FORMAT;
    const size_t count = json_array_size(cases) + 1;
    Row *rows = gp_alloc(count, sizeof *rows);
    bool whole = rows && read_row(mean, &rows[count - 1]);
    for (size_t i = 0; whole && i + 1 < count; i++)
        whole = read_row(json_array_get(cases, i), &rows[i]);
    if (whole) {
        plot_begin(svg, WIDTH, TOP + (int)count * PITCH + GAP + 40, title);
        plot_note(svg, 0, "%s, %d threads each, %s", machine, threads, date);
        plot_note(svg, 1, "%s; %s; medians of %d rounds, both drawn in turn", peer, version,
                  rounds);
        draw_legend(svg);
        draw_rows(rows, count, svg);
        plot_end(svg, 0, "");
    }
    gp_free(rows);
    return whole ? GP_OK : GP_ERROR_FORMAT;
}

GpResult peer_chart_draw(const char *path, Text *svg, GpError *error)
{
    json_error_t reason;
    json_t *root = json_load_file(path, 0, &reason);
    if (!root)
        return gp_fail(error, GP_ERROR_IO, "%s:%d: %s", path, reason.line, reason.text);
    GpResult result = draw(root, svg);
    json_decref(root);
    return gp_fail(error, result, "%s: no comparison", path);
}
