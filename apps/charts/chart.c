#include "apps/charts/chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void chart_free(Chart *chart)
{
    gp_free(chart->points);
    *chart = (Chart){ .points = NULL };
}

/* Whether a is as good as b in time and error, and better in one of them; false for no numbers. */
static bool beats(const ChartPoint *a, const ChartPoint *b)
{
    double error = a->measured.error, other = b->measured.error;
    return a->time.ms <= b->time.ms && error <= other && (a->time.ms < b->time.ms || error < other);
}

/* Whether a is nearer to the truth, or as near and faster. */
static bool beats_in_error(const ChartPoint *a, const ChartPoint *b)
{
    double error = a->measured.error, other = b->measured.error;
    return error < other || (error == other && a->time.ms < b->time.ms);
}

void chart_mark_best(Chart *chart)
{
    for (uint32_t i = 0; i < chart->count; i++) {
        ChartPoint *point = &chart->points[i];
        point->best = !isnan(point->time.ms) && !isnan(point->measured.error);
        for (uint32_t k = 0; k < chart->count && point->best; k++)
            point->best = !beats(&chart->points[k], point);
    }
}

/* Points of the same time are on the front only with the same error: then the sweep's order. */
static int compare_times(const void *a, const void *b)
{
    const ChartPoint *x = *(const ChartPoint *const *)a, *y = *(const ChartPoint *const *)b;
    return x->time.ms != y->time.ms ? (x->time.ms > y->time.ms) - (x->time.ms < y->time.ms)
                                    : (x > y) - (x < y);
}

uint32_t chart_list_best(const Chart *chart, const ChartPoint **best)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < chart->count; i++)
        if (chart->points[i].best)
            best[count++] = &chart->points[i];
    qsort(best, count, sizeof(const ChartPoint *), compare_times);
    return count;
}

/* Ends of the middle half of a point's frames; of charts that do not have them, its time. */
static double early(const ChartPoint *point)
{
    return point->time.low_ms > 0 ? point->time.low_ms : point->time.ms;
}

static double late(const ChartPoint *point)
{
    return point->time.high_ms > 0 ? point->time.high_ms : point->time.ms;
}

/* The fastest of those that are nearer to the truth than `error`. */
static const ChartPoint *fastest_below(const Chart *chart, double error)
{
    const ChartPoint *fastest = NULL;
    for (uint32_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        const bool nearer = point->measured.error < error && !isnan(point->time.ms);
        if (nearer && (!fastest || point->time.ms < fastest->time.ms))
            fastest = point;
    }
    return fastest;
}

/* The most exact of those that are hardly slower than the fastest: on a tie, the faster. */
static const ChartPoint *nearest_beside(const Chart *chart, const ChartPoint *fastest)
{
    const ChartPoint *nearest = fastest;
    for (uint32_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        if (early(point) <= late(fastest) && beats_in_error(point, nearest))
            nearest = point;
    }
    return nearest;
}

uint32_t chart_list_steps(const Chart *chart, const ChartPoint **steps)
{
    uint32_t count = 0;
    double error = HUGE_VAL;
    for (const ChartPoint *at; (at = fastest_below(chart, error)); count++) {
        steps[count] = nearest_beside(chart, at);
        error = steps[count]->measured.error;
    }
    return count;
}

const ChartPoint *chart_choose(const Chart *chart, double error)
{
    const ChartPoint *at = fastest_below(chart, HUGE_VAL), *step = NULL;
    for (; at && !(step && step->measured.error <= error);
         at = fastest_below(chart, step->measured.error))
        step = nearest_beside(chart, at);
    return step && step->measured.error <= error ? step : NULL;
}

double chart_per_cent(const TechniqueError *measured)
{
    if (measured->error == 0)
        return 0;
    return measured->whole > 0 ? 100 * measured->error / measured->whole : (double)NAN;
}

void chart_print_scene(const Chart *chart, char *text, size_t size)
{
    if (chart->width)
        snprintf(text, size, "%s, %u x %u pixels", chart->scene, chart->width, chart->height);
    else
        snprintf(text, size, "%s", chart->scene);
}
