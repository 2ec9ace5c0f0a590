/* Speed against accuracy: every setting of an experiment's sweep, timed and held against the truth.
 *
 * chart_run measures, chart_file writes and reads CSV and JSON, chart_layout lays out, chart_draw
 * draws, chart_page gathers all charts on one page.
 */
#ifndef APPS_CHARTS_CHART_H
#define APPS_CHARTS_CHART_H

#include "apps/frame/timing.h"
#include "apps/techniques/technique.h"

enum {
    CHART_MAX_POINTS = 4096,
    CHART_MAX_PICTURES = 6,
    CHART_MAX_FAILURES = 18,
    CHART_MAX_PATH = 4096
};

typedef struct ChartPoint {
    char method[64], options[SETTING_MAX_TEXT];
    Timing time;
    TechniqueError measured;
    bool best;        /* no other point is as fast and as near to the truth, and better in one */
    char picture[96]; /* its file, beside the chart's; empty: none */
} ChartPoint;

typedef struct Chart {
    char technique[32]; /* the experiment's name */
    char title[128], scene[256], error_name[64];
    char metrics[TECHNIQUE_MAX_METRICS][32];
    int metric_count;
    char machine[128], isa[16];
    int threads;
    double others; /* processors that other programs kept busy meanwhile; below 0: unknown */
    uint32_t width, height; /* of the pictures; 0 where settings make volumes */
    ChartPoint *points;     /* owned, in the order of the sweep */
    uint32_t count;
} Chart;

void chart_free(Chart *chart); /* a zeroed chart is fine; zeroes it */

/* Marks the points of the Pareto front. Points whose time or error is no number are never on it. */
void chart_mark_best(Chart *chart);

/* The points of the front, the fastest first.
 * out     best: room for chart->count
 * returns how many there are */
uint32_t chart_list_best(const Chart *chart, const ChartPoint **best);

/* The front as far as the clock can tell: points whose times overlap, by the middle halves of their
 * frames, are of one time, and the least error of them stands for all. Each step is slower than the
 * one before it and nearer to the truth.
 * out     steps: room for chart->count
 * returns how many there are */
uint32_t chart_list_steps(const Chart *chart, const ChartPoint **steps);

/* The first step whose error is at most `error`; NULL where there is none. */
const ChartPoint *chart_choose(const Chart *chart, double error);

/* An error as a share of its whole, in per cent; NaN where nothing is known of that. */
double chart_per_cent(const TechniqueError *measured);

/* What was drawn: "scenes/a.json, 640 x 480 pixels". */
void chart_print_scene(const Chart *chart, char *text, size_t size);

#endif
