#include "apps/charts/candidates.h"

#include "apps/base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void add(Candidates *candidates, const char *method, const char *options)
{
    for (uint32_t i = 0; i < candidates->count; i++)
        if (strcmp(candidates->list[i].options, options) == 0)
            return;
    Candidate *candidate = &candidates->list[candidates->count++];
    text_copy(candidate->method, sizeof candidate->method, method);
    text_copy(candidate->options, sizeof candidate->options, options);
}

/* --- of a chart ------------------------------------------------------------------------------- */

/* By error, then by time; what has no numbers last. */
static int compare_errors(const void *a, const void *b)
{
    const ChartPoint *x = *(const ChartPoint *const *)a, *y = *(const ChartPoint *const *)b;
    const double error = x->measured.error, other = y->measured.error;
    if (isnan(error) || isnan(other))
        return isnan(error) - isnan(other);
    return error != other ? (error > other) - (error < other)
                          : (x->time.ms > y->time.ms) - (x->time.ms < y->time.ms);
}

static GpResult add_chart(const Chart *chart, double most, bool per_cent, Candidates *candidates)
{
    const ChartPoint **points = gp_alloc(chart->count, sizeof(const ChartPoint *));
    if (!points)
        return GP_ERROR_MEMORY;
    bool holds = false;
    const uint32_t steps = chart_list_steps(chart, points);
    for (uint32_t i = 0; i < steps; i++) {
        const TechniqueError *measured = &points[i]->measured;
        add(candidates, points[i]->method, points[i]->options);
        if (!holds)
            candidates->first = candidates->count - 1;
        holds |= (per_cent ? chart_per_cent(measured) : measured->error) <= most;
    }
    for (uint32_t i = 0; i < chart->count; i++)
        points[i] = &chart->points[i];
    qsort(points, chart->count, sizeof(const ChartPoint *), compare_errors);
    for (uint32_t i = 0; i < chart->count; i++)
        add(candidates, points[i]->method, points[i]->options);
    gp_free(points);
    return GP_OK;
}

/* --- of a sweep ------------------------------------------------------------------------------- */

static bool is_usual(const Experiment *experiment, const char *method)
{
    for (const char *const *usual = experiment->usual; usual && *usual; usual++)
        if (strcmp(*usual, method) == 0)
            return true;
    return false;
}

/* The settings at a place of all rows that are usual, or of all others. returns whether a row has
 * one at that place, or behind it */
static bool add_place(const Experiment *experiment, bool usual, size_t place, SettingText *texts,
                      Candidates *candidates)
{
    bool any = false;
    for (const TechniqueSweep *sweep = experiment->sweep; sweep->method; sweep++) {
        if (is_usual(experiment, sweep->method) != usual)
            continue;
        const size_t count = technique_expand(sweep->options, texts, CHART_MAX_POINTS);
        any |= place < count;
        if (place < count)
            add(candidates, sweep->method, texts[place]);
    }
    return any;
}

static void add_sweep(const Experiment *experiment, SettingText *texts, Candidates *candidates)
{
    for (int usual = 1; usual >= 0; usual--) {
        size_t place = 0;
        while (add_place(experiment, usual == 1, place, texts, candidates))
            place++;
    }
}

/* --- both ------------------------------------------------------------------------------------- */

GpResult candidates_list(const Experiment *experiment, const Chart *chart, double most,
                         bool per_cent, Candidates *candidates, GpError *error)
{
    size_t room = chart ? chart->count : 0;
    for (const TechniqueSweep *row = experiment->sweep; row->method; row++)
        room += technique_expand(row->options, NULL, 0);
    Candidates made = { .list = gp_alloc(room, sizeof *made.list) };
    SettingText *texts = gp_alloc(CHART_MAX_POINTS, sizeof *texts);
    GpResult result = made.list && texts ? GP_OK : GP_ERROR_MEMORY;
    if (!result && chart)
        result = add_chart(chart, most, per_cent, &made);
    if (!result)
        add_sweep(experiment, texts, &made);
    gp_free(texts);
    if (result) {
        gp_free(made.list);
        return gp_fail(error, result, "out of memory");
    }
    *candidates = made;
    return GP_OK;
}
