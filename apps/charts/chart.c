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

const ChartPoint *chart_choose(const Chart *chart, double error)
{
    const ChartPoint *chosen = NULL;
    for (uint32_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        bool enough = point->measured.error <= error && !isnan(point->time.ms);
        if (enough && (!chosen || point->time.ms < chosen->time.ms || beats(point, chosen)))
            chosen = point;
    }
    return chosen;
}

void chart_print_scene(const Chart *chart, char *text, size_t size)
{
    if (chart->width)
        snprintf(text, size, "%s, %u x %u pixels", chart->scene, chart->width, chart->height);
    else
        snprintf(text, size, "%s", chart->scene);
}
