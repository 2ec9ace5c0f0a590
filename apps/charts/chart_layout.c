#include "apps/charts/chart_layout.h"

#include "apps/charts/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- points ----------------------------------------------------------------------------------- */

/* Time and error are numbers such as a measurement can give. */
static bool has_place(const ChartPoint *point)
{
    double ms = point->time.ms, error = point->measured.error;
    return ms >= 1e-6 && ms <= 1e9 && (error == 0 || (error >= 1e-12 && error <= 1e12));
}

/* Charts do not always have quartiles. */
static bool has_bar(const ChartPoint *point)
{
    const Timing *time = &point->time;
    return time->low_ms >= 1e-6 && time->high_ms <= 1e9 && time->low_ms <= time->ms &&
           time->ms <= time->high_ms;
}

static void make_scales(Plot *plot, const Chart *chart)
{
    enum { ZERO_STRIP = 44 };
    PlotRange ms = { 0 }, error = { 0 };
    for (uint32_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        if (!has_place(point))
            continue;
        plot_range_add(&ms, point->time.ms);
        if (has_bar(point)) {
            plot_range_add(&ms, point->time.low_ms);
            plot_range_add(&ms, point->time.high_ms);
        }
        if (point->measured.error > 0)
            plot_range_add(&error, point->measured.error);
        else
            plot->has_zero = true;
    }
    double bottom = plot->box.bottom - (plot->has_zero ? ZERO_STRIP : 0);
    plot->x = plot_scale(ms, plot->box.left, plot->box.right);
    plot->y = plot_scale(error, bottom, plot->box.top);
    plot->zero_y = plot->box.bottom - ZERO_STRIP / 2.0;
}

/* A point that has a place; one without error is in the strip. */
static PlotPoint place(Plot *plot, const ChartPoint *point)
{
    const double error = point->measured.error;
    const bool bar = has_bar(point);
    return (PlotPoint){ .point = point,
                        .x = plot_place(&plot->x, point->time.ms),
                        .left = plot_place(&plot->x, bar ? point->time.low_ms : point->time.ms),
                        .right = plot_place(&plot->x, bar ? point->time.high_ms : point->time.ms),
                        .y = error > 0 ? plot_place(&plot->y, error) : plot->zero_y,
                        .method = plot_series(plot->methods, &plot->method_count, point->method) };
}

/* --- labels ----------------------------------------------------------------------------------- */

/* Whether all points of the point's method have this option (as much of a text as `length`). */
static bool all_have(const Chart *chart, const ChartPoint *of, const char *option, size_t length)
{
    for (uint32_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        if (strcmp(point->method, of->method) != 0)
            continue;
        bool found = false;
        for (const char *at = point->options; *at && !found; at++)
            found = strncmp(at, option, length) == 0 && (at[length] == ' ' || !at[length]);
        if (!found)
            return false;
    }
    return true;
}

/* The method, and what distinguishes a point from others of it: "plain: map 2048, slope 2". */
static void short_text(const Chart *chart, const ChartPoint *point, char text[PLOT_MAX_LABEL])
{
    size_t used = (size_t)snprintf(text, PLOT_MAX_LABEL, "%s", point->method);
    const char *between = ": ";
    for (const char *at = point->options; (at = strstr(at, "--"));) {
        const char *end = strstr(at + 2, " --");
        size_t length = end ? (size_t)(end - at) : strlen(at);
        if (!all_have(chart, point, at, length)) {
            used += (size_t)snprintf(text + used, PLOT_MAX_LABEL - used, "%s%.*s", between,
                                     (int)(length - 2), at + 2);
            between = ", ";
        }
        at += length;
    }
}

static PlotBox label_box(const PlotLabel *label)
{
    const double per_letter = 6.1, above = 10, below = 3;
    double width = per_letter * (double)strlen(label->text);
    double left = label->ends ? label->x - width : label->x;
    return (PlotBox){ left, label->y - above, left + width, label->y + below };
}

/* Whether nothing else is where the label would be: no marker, no step of the front's line, no
 * earlier label, no edge. */
static bool is_free(const Plot *plot, const PlotLabel *label)
{
    const double radius = 6;
    PlotBox box = label_box(label), inside = plot->box;
    if (box.left < inside.left + 4 || box.right > inside.right - 4 || box.top < inside.top ||
        box.bottom > inside.bottom - 2)
        return false;
    for (uint32_t i = 0; i < plot->count; i++) {
        const PlotPoint *point = &plot->points[i];
        if (plot_overlap(box, (PlotBox){ point->x - radius, point->y - radius, point->x + radius,
                                         point->y + radius }) ||
            plot_overlap(box, (PlotBox){ point->left, point->y - 1, point->right, point->y + 1 }))
            return false;
    }
    for (uint32_t i = 0; i + 1 < plot->best_count; i++) {
        const PlotPoint *a = &plot->best[i], *b = &plot->best[i + 1];
        if (plot_overlap(box, (PlotBox){ a->x, a->y - 1, b->x, a->y + 1 }) ||
            plot_overlap(box, (PlotBox){ b->x - 1, a->y, b->x + 1, b->y }))
            return false;
    }
    for (uint32_t i = 0; i < plot->label_count; i++)
        if (plot_overlap(box, label_box(&plot->labels[i])))
            return false;
    return true;
}

/* Whether the line from a label to its point crosses no other label. */
static bool is_in_sight(const Plot *plot, const PlotLabel *label)
{
    enum { STEPS = 24 };
    for (int step = 0; step <= STEPS; step++) {
        const double share = (double)step / STEPS, half = 1.5;
        const double x = label->dot[0] + share * (label->x - label->dot[0]);
        const double y = label->dot[1] + share * (label->y - 4 - label->dot[1]);
        for (uint32_t i = 0; i < plot->label_count; i++)
            if (plot_overlap(label_box(&plot->labels[i]),
                             (PlotBox){ x - half, y - half, x + half, y + half }))
                return false;
    }
    return true;
}

/* Left of the front and below it there are no points, so labels go there first; then all around,
 * ever farther away. */
static void place_label(Plot *plot, PlotLabel *label)
{
    enum { RINGS = 18, BESIDE = 10, APART = 22, RING = 13 };
    static const double ways[][2] = { { -1, 0.4 }, { -0.7, 1 },  { -0.2, 1 }, { 0.2, 1 },
                                      { 1, -0.4 }, { 0.8, -1 },  { 0.7, 1 },  { -0.4, -1 },
                                      { 0.3, -1 }, { -1, -0.6 }, { 1, 0.4 },  { -1, 1 } };
    for (int ring = 0; ring < RINGS; ring++) {
        const double far = BESIDE + RING * ring;
        for (size_t i = 0; i < GP_COUNT(ways); i++) {
            label->x = label->dot[0] + far * ways[i][0];
            label->y = label->dot[1] + far * ways[i][1] + (ways[i][1] > 0 ? 6 : 0);
            label->ends = ways[i][0] < 0;
            label->apart = far > APART;
            if (is_free(plot, label) && (!label->apart || is_in_sight(plot, label))) {
                plot->labels[plot->label_count++] = *label;
                return;
            }
        }
    }
}

static void make_labels(Plot *plot, const Chart *chart)
{
    for (uint32_t i = 0; i < plot->best_count; i++) {
        PlotLabel label = { .dot = { plot->best[i].x, plot->best[i].y } };
        short_text(chart, plot->best[i].point, label.text);
        place_label(plot, &label);
    }
}

/* --- all of it -------------------------------------------------------------------------------- */

static void make_points(Plot *plot, const Chart *chart, const ChartPoint **best)
{
    for (uint32_t i = 0; i < chart->count; i++) {
        plot_series(plot->methods, &plot->method_count, chart->points[i].method);
        if (has_place(&chart->points[i]))
            plot->points[plot->count++] = place(plot, &chart->points[i]);
        else
            plot->left_out++;
    }
    uint32_t count = chart_list_best(chart, best);
    for (uint32_t i = 0; i < count; i++)
        if (has_place(best[i]))
            plot->best[plot->best_count++] = place(plot, best[i]);
}

GpResult plot_create(const Chart *chart, PlotBox box, Plot *plot)
{
    const ChartPoint **best = gp_alloc(chart->count, sizeof(const ChartPoint *));
    *plot = (Plot){ .box = box,
                    .points = gp_alloc(chart->count, sizeof *plot->points),
                    .best = gp_alloc(chart->count, sizeof *plot->best),
                    .methods = gp_alloc(chart->count, sizeof(const char *)),
                    .labels = gp_alloc(chart->count, sizeof *plot->labels) };
    const bool enough = best && plot->points && plot->best && plot->methods && plot->labels;
    if (enough) {
        make_scales(plot, chart);
        make_points(plot, chart, best);
        make_labels(plot, chart);
    } else {
        plot_free(plot);
    }
    gp_free(best);
    return enough ? GP_OK : GP_ERROR_MEMORY;
}

void plot_free(Plot *plot)
{
    gp_free(plot->points);
    gp_free(plot->best);
    gp_free(plot->methods);
    gp_free(plot->labels);
    *plot = (Plot){ .points = NULL };
}
