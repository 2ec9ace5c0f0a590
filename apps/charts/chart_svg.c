/* A chart as a picture: time against error, both logarithmic, a shape and a colour for each method,
 * the front as a line of steps, and all other points in grey. */
#include "apps/charts/chart_plot.h"
#include "apps/charts/svg.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 1240, HEIGHT = 800, MARGIN = 32, LEGEND_X = 928, LEGEND_ROW = 24 };

static const PlotBox plot_box = { 104, 134, 896, 712 };

/* --- axes ------------------------------------------------------------------------------------- */

static void draw_axes(const Chart *chart, const Plot *plot, Text *svg)
{
    PlotBox box = plot->box;
    char name[96];
    text_add(svg, "<g fill=\"%s\">\n", svg_soft);
    svg_axis_below(svg, &plot->x, box, "time of a frame in milliseconds (median, logarithmic)");
    snprintf(name, sizeof name, "%s (logarithmic%s)", chart->error_name,
             plot->has_zero ? "; 0: none" : "");
    svg_axis_left(svg, &plot->y, box, MARGIN + 6, name);
    if (plot->has_zero) {
        svg_dots(svg, box.left, plot->y.begin, box.right, plot->y.begin);
        svg_words(svg, box.left - 10, plot->zero_y + 4, "end", " font-weight=\"bold\"", "0");
    }
    svg_border(svg, box);
    text_add(svg, "</g>\n");
}

/* --- points ----------------------------------------------------------------------------------- */

/* The best that can be had in a time: from each point right, then down to the next; thinner where
 * it goes on beyond its ends. */
static void draw_front(const Plot *plot, Text *svg)
{
    double x = 0, y = 0;
    if (plot->best_count == 0)
        return;
    text_add(svg, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" d=\"", svg_soft);
    for (uint32_t i = 0; i < plot->best_count; i++) {
        x = plot_place(&plot->x, plot->best[i]->ms);
        y = plot_error_place(plot, plot->best[i]->measured.error);
        if (i == 0)
            text_add(svg, "M%.1f %.1f", x, y);
        else
            text_add(svg, "H%.1fV%.1f", x, y);
    }
    double first = plot_place(&plot->x, plot->best[0]->ms);
    double first_y = plot_error_place(plot, plot->best[0]->measured.error);
    text_add(svg,
             "\"/>\n<path fill=\"none\" stroke=\"%s\" stroke-dasharray=\"3 4\" "
             "d=\"M%.1f %.1fV%.1fM%.1f %.1fH%.1f\"/>\n",
             svg_soft, first, first_y, plot->box.top, x, y, plot->box.right);
}

/* What shows where the pointer rests. */
static void add_tooltip(const Chart *chart, const ChartPoint *point, Text *svg)
{
    text_add(svg, "<title>");
    text_add_escaped(svg, point->method);
    text_add(svg, "\n");
    text_add_escaped(svg, point->options);
    text_add(svg, "\n%.3g ms (least %.3g, processor %.3g; %u frames)\n", point->ms, point->min_ms,
             point->cpu_ms, point->frames);
    text_add_escaped(svg, chart->error_name);
    text_add(svg, ": %.6g", point->measured.error);
    for (int i = 0; i < chart->metric_count; i++) {
        text_add(svg, "\n");
        text_add_escaped(svg, chart->metrics[i]);
        text_add(svg, ": %.6g", point->measured.metrics[i]);
    }
    text_add(svg, "</title>");
}

/* Beaten points first, so that they cover none of the front. */
static void draw_points(const Chart *chart, const Plot *plot, Text *svg)
{
    for (int best = 0; best < 2; best++) {
        for (uint32_t i = 0; i < plot->count; i++) {
            const PlotPoint *point = &plot->points[i];
            if (point->point->best != (best == 1))
                continue;
            text_add(svg, "<g>");
            add_tooltip(chart, point->point, svg);
            svg_marker(svg, point->x, point->y, point->method, best == 0);
            text_add(svg, "</g>\n");
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
    svg_words(svg, LEGEND_X, y, "start", " font-weight=\"bold\"", "method");
    svg_words(svg, WIDTH - MARGIN, y, "end", "", "best / settings");
    for (int i = 0; i < plot->method_count; i++) {
        y += LEGEND_ROW;
        snprintf(note, sizeof note, "%u / %u", count_of(chart, plot->methods[i], true),
                 count_of(chart, plot->methods[i], false));
        svg_marker(svg, LEGEND_X + 8, y - 4, i, false);
        svg_words(svg, LEGEND_X + 24, y, "start", "", plot->methods[i]);
        svg_words(svg, WIDTH - MARGIN, y, "end", "", note);
    }
    y += LEGEND_ROW + 8;
    text_add(svg, "<path d=\"M%d %.1fh8v8h8\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"/>\n",
             LEGEND_X, y - 8, svg_soft);
    svg_words(svg, LEGEND_X + 24, y, "start", "", "least error within a time");
    y += LEGEND_ROW;
    svg_marker(svg, LEGEND_X + 8, y - 4, 0, true);
    svg_words(svg, LEGEND_X + 24, y, "start", "", "beaten by another setting");
    if (plot->left_out == 0)
        return;
    snprintf(note, sizeof note, "not shown: %u that no axis can hold", plot->left_out);
    svg_words(svg, LEGEND_X + 24, y + LEGEND_ROW, "start", "", note);
}

static void draw_words(const Chart *chart, const Plot *plot, int height, Text *svg)
{
    char note[640], threads[32], scene[320];
    snprintf(threads, sizeof threads, "%d thread%s", chart->threads,
             chart->threads == 1 ? "" : "s");
    chart_print_scene(chart, scene, sizeof scene);
    svg_words(svg, MARGIN, 48, "start", " font-size=\"24\" font-weight=\"bold\"", chart->title);
    snprintf(note, sizeof note, "Scene %s. Measured on %s, %s, %s.", scene, chart->machine,
             chart->isa, threads);
    svg_words(svg, MARGIN, 74, "start", " font-size=\"13\"", note);
    snprintf(note, sizeof note, "%u settings of %d method%s, %u of them best.", chart->count,
             plot->method_count, plot->method_count == 1 ? "" : "s", plot->best_count);
    svg_words(svg, MARGIN, 94, "start", " font-size=\"13\"", note);
    svg_words(
        svg, MARGIN, height - 18, "start", " font-size=\"13\" font-style=\"italic\"",
        "How to read: left and low is better. In colour: no other setting is both faster and more "
        "exact. Grey: another setting is both faster and more exact.");
}

void chart_draw(const Chart *chart, Text *svg)
{
    Plot plot;
    if (plot_create(chart, plot_box, &plot)) {
        svg->failed = true;
        return;
    }
    int needed = (int)plot_box.top + (plot.method_count + 4) * LEGEND_ROW;
    int height = needed > HEIGHT ? needed : HEIGHT;
    svg_begin(svg, WIDTH, height, chart->title);
    draw_axes(chart, &plot, svg);
    draw_front(&plot, svg);
    draw_points(chart, &plot, svg);
    draw_labels(&plot, svg);
    draw_legend(chart, &plot, svg);
    draw_words(chart, &plot, height, svg);
    svg_end(svg);
    plot_free(&plot);
}
