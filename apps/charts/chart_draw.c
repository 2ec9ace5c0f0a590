#include "apps/charts/chart_draw.h"

#include "apps/charts/chart_layout.h"
#include "apps/charts/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 1240, HEIGHT = 800, LEGEND_X = 928, LEGEND_ROW = 24, PANE = 190 };

static const PlotBox plot_box = { 104, 134, 896, 712 };

/* --- axes ------------------------------------------------------------------------------------- */

static void draw_axes(const Chart *chart, const Plot *plot, Text *svg)
{
    PlotBox box = plot->box;
    char name[96];
    text_add(svg, "<g fill=\"%s\">\n", svg_soft);
    snprintf(name, sizeof name, "%s (logarithmic%s)", chart->error_name,
             plot->has_zero ? "; 0: none" : "");
    plot_axes(svg, box, &plot->x, "time of a frame in milliseconds (median, logarithmic)", &plot->y,
              name, PLOT_MARGIN + 6);
    if (plot->has_zero) {
        svg_dots(svg, box.left, plot->y.begin, box.right, plot->y.begin);
        svg_words(svg, box.left - 10, plot->zero_y + 4, "end", svg_bold, "0");
    }
    text_add(svg, "</g>\n");
}

/* --- points ----------------------------------------------------------------------------------- */

/* The best that can be had in a time: from each point right, then down to the next; thinner where
 * it goes on beyond its ends. */
static void draw_front(const Plot *plot, Text *svg)
{
    const PlotPoint *first = plot->best, *last = first + plot->best_count - 1;
    if (plot->best_count == 0)
        return;
    text_add(svg, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" d=\"M%.1f %.1f", svg_soft,
             first->x, first->y);
    for (const PlotPoint *point = first + 1; point <= last; point++)
        text_add(svg, "H%.1fV%.1f", point->x, point->y);
    text_add(svg,
             "\"/>\n<path fill=\"none\" stroke=\"%s\" stroke-dasharray=\"3 4\" "
             "d=\"M%.1f %.1fV%.1fM%.1f %.1fH%.1f\"/>\n",
             svg_soft, first->x, first->y, plot->box.top, last->x, last->y, plot->box.right);
}

/* All that is known of a point: a name, then lines. */
static Text list_facts(const Chart *chart, const ChartPoint *point)
{
    Text facts = { .data = NULL };
    char number[32];
    text_add(&facts, "%s\n%s\n", point->method, point->options);
    plot_tooltip_times(&facts, &point->time);
    text_for_people(point->measured.error, 6, number);
    text_add(&facts, "\n%s: %s", chart->error_name, number);
    for (int i = 0; i < chart->metric_count; i++) {
        text_for_people(point->measured.metrics[i], 6, number);
        text_add(&facts, "\n%s: %s", chart->metrics[i], number);
    }
    return facts;
}

/* How much of a line goes into one of a pane: whole words, if there are any. */
static size_t line_length(const char *line, size_t length)
{
    enum { LETTERS = 44 };
    if (length <= LETTERS)
        return length;
    for (size_t i = LETTERS; i > LETTERS / 2; i--)
        if (line[i] == ' ')
            return i;
    return LETTERS;
}

/* The same at a place of its own, where the pointer or the keyboard is on the point. */
static void draw_pane(const char *facts, double y, Text *svg)
{
    enum { LINE = 15 };
    text_add(svg, "<g class=\"pane\">");
    while (*facts) {
        char line[64];
        const size_t rest = strcspn(facts, "\n"), length = line_length(facts, rest);
        snprintf(line, sizeof line, "%.*s", (int)length, facts);
        svg_words(svg, LEGEND_X, y, "start", " font-size=\"11.5\"", line);
        facts += length + (facts[length] == '\n' || facts[length] == ' ');
        y += LINE;
    }
    text_add(svg, "</g>");
}

static void draw_bar(const PlotPoint *point, Text *svg)
{
    const double cap = 3;
    if (!(point->left < point->right))
        return;
    text_add(svg, "<path d=\"M%.1f %.1fv%.1fm0 %.1fH%.1fm0 %.1fv%.1f\" stroke=\"%s\"/>",
             point->left, point->y - cap, 2 * cap, -cap, point->right, -cap, 2 * cap,
             point->point->best ? plot_color(point->method) : svg_frame);
}

/* Beaten points first, so that they cover none of the front, whose points the keyboard reaches. */
static void draw_points(const Chart *chart, const Plot *plot, double pane_y, Text *svg)
{
    for (int best = 0; best < 2; best++) {
        for (uint32_t i = 0; i < plot->count; i++) {
            const PlotPoint *point = &plot->points[i];
            if (point->point->best != (best == 1))
                continue;
            Text facts = list_facts(chart, point->point);
            svg->failed |= facts.failed;
            text_add(svg, best ? "<g class=\"best\" tabindex=\"0\" role=\"img\">" : "<g>");
            text_add_escaped(svg, "<title>%s</title>", facts.data ? facts.data : "");
            draw_bar(point, svg);
            plot_marker(svg, point->x, point->y, point->method, best == 0);
            if (best && facts.data)
                draw_pane(facts.data, pane_y, svg);
            text_add(svg, "</g>\n");
            text_free(&facts);
        }
    }
}

static void draw_labels(const Plot *plot, Text *svg)
{
    for (uint32_t i = 0; i < plot->label_count; i++) {
        const PlotLabel *label = &plot->labels[i];
        if (label->apart)
            svg_line(svg, label->dot[0], label->dot[1], label->x, label->y - 4, svg_frame);
        svg_words(svg, label->x, label->y, label->ends ? "end" : "start", svg_small_words,
                  label->text);
    }
}

/* --- around the plot -------------------------------------------------------------------------- */

static uint32_t count_of(const Chart *chart, const char *method, bool only_best)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < chart->count; i++)
        count +=
            strcmp(chart->points[i].method, method) == 0 && (chart->points[i].best || !only_best);
    return count;
}

static void draw_legend(const Chart *chart, const Plot *plot, Text *svg)
{
    double y = plot->box.top + 10;
    char note[64];
    svg_words(svg, LEGEND_X, y, "start", svg_bold, "method");
    svg_words(svg, WIDTH - PLOT_MARGIN, y, "end", "", "best / settings");
    for (int i = 0; i < plot->method_count; i++) {
        y += LEGEND_ROW;
        snprintf(note, sizeof note, "%u / %u", count_of(chart, plot->methods[i], true),
                 count_of(chart, plot->methods[i], false));
        plot_marker(svg, LEGEND_X + 8, y - 4, i, false);
        svg_words(svg, LEGEND_X + 24, y, "start", "", plot->methods[i]);
        svg_words(svg, WIDTH - PLOT_MARGIN, y, "end", "", note);
    }
    y += LEGEND_ROW + 8;
    text_add(svg, "<path d=\"M%d %.1fh8v8h8\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"/>\n",
             LEGEND_X, y - 8, svg_soft);
    svg_words(svg, LEGEND_X + 24, y, "start", "", "least error within a time");
    y += LEGEND_ROW;
    plot_marker(svg, LEGEND_X + 8, y - 4, 0, true);
    svg_words(svg, LEGEND_X + 24, y, "start", "", "beaten by another setting");
    y += LEGEND_ROW;
    text_add(svg, "<path d=\"M%d %.1fv6m0 -3h16m0 -3v6\" stroke=\"%s\"/>\n", LEGEND_X, y - 7,
             svg_soft);
    svg_words(svg, LEGEND_X + 24, y, "start", "", "middle half of the frames' times");
    if (plot->left_out == 0)
        return;
    snprintf(note, sizeof note, "not shown: %u that no axis can hold", plot->left_out);
    svg_words(svg, LEGEND_X + 24, y + LEGEND_ROW, "start", "", note);
}

static void draw_notes(const Chart *chart, const Plot *plot, Text *svg)
{
    char scene[320], words[336];
    chart_print_scene(chart, scene, sizeof scene);
    snprintf(words, sizeof words, "Scene %s. ", scene);
    plot_machine(svg, 1, words,
                 &(PlotMachine){ chart->machine, chart->isa, chart->threads, chart->others });
    plot_note(svg, 0, "%u settings of %d method%s, %u of them best.", chart->count,
              plot->method_count, plot->method_count == 1 ? "" : "s", plot->best_count);
}

void chart_draw(const Chart *chart, Text *svg)
{
    Plot plot;
    if (plot_create(chart, plot_box, &plot)) {
        svg->failed = true;
        return;
    }
    const int pane = (int)plot_box.top + (plot.method_count + 5) * LEGEND_ROW + LEGEND_ROW / 2;
    const int needed = pane + PANE;
    const int height = needed > HEIGHT ? needed : HEIGHT;
    plot_begin(svg, WIDTH, height, chart->title);
    draw_notes(chart, &plot, svg);
    draw_axes(chart, &plot, svg);
    draw_front(&plot, svg);
    draw_points(chart, &plot, pane, svg);
    draw_labels(&plot, svg);
    draw_legend(chart, &plot, svg);
    plot_end(
        svg, height,
        "How to read: left and low is better. In colour: no other setting is both faster and "
        "more exact; point at one, or reach it by the tab key, for all its numbers. Grey: beaten.");
    plot_free(&plot);
}
