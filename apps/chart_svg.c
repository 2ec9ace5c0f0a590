/* A chart as a picture: time against error, both logarithmic, a shape and a colour for each method,
 * the front as a line of steps, and all other points in grey. */
#include "apps/chart_plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 1240, HEIGHT = 800, MARGIN = 32, LEGEND_X = 928, LEGEND_ROW = 24 };

static const PlotBox plot_box = { 104, 134, 896, 712 };

static const char ink[] = "#1f2430", soft[] = "#5b6472", grid[] = "#e9ecf0", frame[] = "#aab2bd";

/* Colours that differ for all kinds of eyes: Okabe and Ito's (without yellow), then Tol's muted. */
static const char *const colors[] = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#222222",
    "#332288", "#882255", "#117733", "#999933", "#aa4499", "#44aa99", "#661100",
};

/* Outlines about the origin, of similar weight: shapes tell methods apart in print. */
static const char *const shapes[] = {
    "M6 0A6 6 0 1 1 -6 0A6 6 0 1 1 6 0Z",                           /* circle */
    "M-5.3 -5.3H5.3V5.3H-5.3Z",                                     /* square */
    "M0 -7L6.6 4.8H-6.6Z",                                          /* triangle */
    "M0 -7.4L7 0L0 7.4L-7 0Z",                                      /* diamond */
    "M0 7L6.6 -4.8H-6.6Z",                                          /* triangle down */
    "M-2.2 -6.6H2.2V-2.2H6.6V2.2H2.2V6.6H-2.2V2.2H-6.6V-2.2H-2.2Z", /* plus */
    "M0 -7.6L2 -2.4L7.4 -2.3L3.1 1.1L4.6 6.4L0 3.3L-4.6 6.4L-3.1 1.1L-7.4 -2.3L-2 -2.4Z", /* star */
    "M-7 0L-3.5 -6H3.5L7 0L3.5 6H-3.5Z",                   /* hexagon */
    "M-6 -6H6L-6 6H6Z",                                    /* hourglass */
    "M7 0L-4.8 6.6V-6.6Z",                                 /* triangle right */
    "M-6 -3l3-3 3 3 3-3 3 3-3 3 3 3-3 3-3-3-3 3-3-3 3-3Z", /* cross */
    "M-7 0L4.8 6.6V-6.6Z",                                 /* triangle left */
    "M-6 -6V6L6 -6V6Z",                                    /* bow tie */
    "M0 -6.8L6.5 -2.1L4 5.5H-4L-6.5 -2.1Z",                /* pentagon */
};

/* More methods than shapes: the second round pairs them with other colours. */
static const char *shape_of(int method)
{
    return shapes[(size_t)method % GP_COUNT(shapes)];
}

static const char *color_of(int method)
{
    size_t number = (size_t)method;
    return colors[(number + number / GP_COUNT(shapes)) % GP_COUNT(colors)];
}

/* --- pieces ----------------------------------------------------------------------------------- */

static void line(Text *svg, double x1, double y1, double x2, double y2, const char *color)
{
    text_add(svg, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1, y1,
             x2, y2, color);
}

/* anchor: start, middle or end; more: further attributes */
static void words(Text *svg, double x, double y, const char *anchor, const char *more,
                  const char *content)
{
    text_add(svg, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", x, y, anchor, more);
    text_add_escaped(svg, content);
    text_add(svg, "</text>\n");
}

static void marker(Text *svg, double x, double y, int method, bool best)
{
    text_add(svg,
             "<path d=\"%s\" transform=\"translate(%.1f %.1f)\" fill=\"%s\" stroke=\"%s\" "
             "stroke-width=\"1\"/>",
             shape_of(method), x, y, best ? color_of(method) : "#d3d8df",
             best ? "#ffffff" : "#9ea7b3");
}

/* --- axes ------------------------------------------------------------------------------------- */

static void draw_time_axis(const Plot *plot, Text *svg)
{
    bool labelled;
    PlotBox box = plot->box;
    for (double ms = 0; (ms = plot_next_tick(&plot->x, ms, &labelled)) > 0;) {
        double x = plot_place(&plot->x, ms);
        char number[32];
        snprintf(number, sizeof number, "%g", ms);
        line(svg, x, box.top, x, box.bottom, grid);
        line(svg, x, box.bottom, x, box.bottom + (labelled ? 6 : 3), frame);
        if (labelled)
            words(svg, x, box.bottom + 21, "middle", "", number);
    }
    words(svg, (box.left + box.right) / 2, box.bottom + 44, "middle", " font-size=\"14\"",
          "time of a frame in milliseconds (median, logarithmic)");
}

static void draw_error_axis(const Chart *chart, const Plot *plot, Text *svg)
{
    bool labelled;
    PlotBox box = plot->box;
    for (double error = 0; (error = plot_next_tick(&plot->y, error, &labelled)) > 0;) {
        double y = plot_place(&plot->y, error);
        char number[32];
        snprintf(number, sizeof number, error < 1e6 && error >= 1 ? "%.0f" : "%g", error);
        line(svg, box.left, y, box.right, y, grid);
        line(svg, box.left - (labelled ? 6 : 3), y, box.left, y, frame);
        if (labelled)
            words(svg, box.left - 10, y + 4, "end", "", number);
    }
    if (plot->has_zero) {
        text_add(svg,
                 "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
                 "stroke-dasharray=\"2 4\"/>\n",
                 box.left, plot->y.begin, box.right, plot->y.begin, frame);
        words(svg, box.left - 10, plot->zero_y + 4, "end", " font-weight=\"bold\"", "0");
    }
    char name[96], turned[64];
    double middle = (box.top + box.bottom) / 2;
    snprintf(name, sizeof name, "%s (logarithmic%s)", chart->error_name,
             plot->has_zero ? "; 0: none" : "");
    snprintf(turned, sizeof turned, " font-size=\"14\" transform=\"rotate(-90 %d %.1f)\"",
             MARGIN + 6, middle);
    words(svg, MARGIN + 6, middle, "middle", turned, name);
}

/* --- points ----------------------------------------------------------------------------------- */

/* The best that can be had in a time: from each point right, then down to the next; thinner where
 * it goes on beyond its ends. */
static void draw_front(const Plot *plot, Text *svg)
{
    double x = 0, y = 0;
    if (plot->best_count == 0)
        return;
    text_add(svg, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" d=\"", soft);
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
             soft, first, first_y, plot->box.top, x, y, plot->box.right);
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
    for (int i = 0; i < chart->figure_count; i++) {
        text_add(svg, "\n");
        text_add_escaped(svg, chart->figures[i]);
        text_add(svg, ": %.6g", point->measured.figures[i]);
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
            marker(svg, point->x, point->y, point->method, best);
            text_add(svg, "</g>\n");
        }
    }
}

static void draw_labels(const Plot *plot, Text *svg)
{
    for (uint32_t i = 0; i < plot->label_count; i++) {
        const PlotLabel *label = &plot->labels[i];
        if (label->apart)
            line(svg, label->dot[0], label->dot[1], label->x, label->y - 4, frame);
        words(svg, label->x, label->y, label->ends ? "end" : "start",
              " font-size=\"11\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\" "
              "stroke-linejoin=\"round\"",
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
    words(svg, LEGEND_X, y, "start", " font-weight=\"bold\"", "method");
    words(svg, WIDTH - MARGIN, y, "end", "", "best / settings");
    for (int i = 0; i < plot->method_count; i++) {
        y += LEGEND_ROW;
        snprintf(note, sizeof note, "%u / %u", count_of(chart, plot->methods[i], true),
                 count_of(chart, plot->methods[i], false));
        marker(svg, LEGEND_X + 8, y - 4, i, true);
        words(svg, LEGEND_X + 24, y, "start", "", plot->methods[i]);
        words(svg, WIDTH - MARGIN, y, "end", "", note);
    }
    y += LEGEND_ROW + 8;
    text_add(svg, "<path d=\"M%d %.1fh8v8h8\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"/>\n",
             LEGEND_X, y - 8, soft);
    words(svg, LEGEND_X + 24, y, "start", "", "least error within a time");
    y += LEGEND_ROW;
    marker(svg, LEGEND_X + 8, y - 4, 0, false);
    words(svg, LEGEND_X + 24, y, "start", "", "beaten by another setting");
    if (plot->left_out == 0)
        return;
    snprintf(note, sizeof note, "not shown: %u that no axis can hold", plot->left_out);
    words(svg, LEGEND_X + 24, y + LEGEND_ROW, "start", "", note);
}

static void draw_words(const Chart *chart, const Plot *plot, int height, Text *svg)
{
    char note[640], threads[32], size[32];
    snprintf(threads, sizeof threads, "%d thread%s", chart->threads,
             chart->threads == 1 ? "" : "s");
    snprintf(size, sizeof size, "%u x %u", chart->width, chart->height);
    words(svg, MARGIN, 48, "start", " font-size=\"24\" font-weight=\"bold\"", chart->title);
    snprintf(note, sizeof note, "Scene %s, %s pixels. Measured on %s, %s, %s.", chart->scene, size,
             chart->machine, chart->isa, threads);
    words(svg, MARGIN, 74, "start", " font-size=\"13\"", note);
    snprintf(note, sizeof note, "%u settings of %d method%s, %u of them best.", chart->count,
             plot->method_count, plot->method_count == 1 ? "" : "s", plot->best_count);
    words(svg, MARGIN, 94, "start", " font-size=\"13\"", note);
    words(
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
    text_add(svg,
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
             "height=\"%d\" role=\"img\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" "
             "font-size=\"12\">\n<title>",
             WIDTH, height, WIDTH, height);
    text_add_escaped(svg, chart->title);
    text_add(svg,
             "</title>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n"
             "<g fill=\"%s\">\n",
             soft);
    draw_time_axis(&plot, svg);
    draw_error_axis(chart, &plot, svg);
    text_add(svg,
             "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" "
             "stroke=\"%s\"/>\n</g>\n<g fill=\"%s\">\n",
             plot.box.left, plot.box.top, plot.box.right - plot.box.left,
             plot.box.bottom - plot.box.top, frame, ink);
    draw_front(&plot, svg);
    draw_points(chart, &plot, svg);
    draw_labels(&plot, svg);
    draw_legend(chart, &plot, svg);
    draw_words(chart, &plot, height, svg);
    text_add(svg, "</g>\n</svg>\n");
    plot_free(&plot);
}
