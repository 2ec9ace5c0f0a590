/* The geometry of a chart's picture: its points on their axes, and where labels find room. */
#ifndef APPS_CHARTS_CHART_LAYOUT_H
#define APPS_CHARTS_CHART_LAYOUT_H

#include "apps/charts/chart.h"
#include "apps/charts/axis.h"

/* A point that has a place. */
typedef struct PlotPoint {
    const ChartPoint *point;
    double x, y;
    double left, right; /* ends of its bar, from the lower quartile of its times to the upper one */
    int method;         /* number of its method, in the order of the chart */
} PlotPoint;

enum { PLOT_MAX_LABEL = SETTING_MAX_TEXT + 64 };

typedef struct PlotLabel {
    char text[PLOT_MAX_LABEL];
    double x, y;      /* of the text's base line; x: its begin, or its end */
    double dot[2];    /* the point that it belongs to */
    bool ends, apart; /* x is the end; far enough to need a line to its point */
} PlotLabel;

typedef struct Plot {
    PlotBox box;    /* inside the axes */
    PlotScale x, y; /* milliseconds; error */
    bool has_zero;  /* points without any error are in a strip of their own, at zero_y */
    double zero_y;
    PlotPoint *points;
    uint32_t count, left_out; /* with a place; without: no numbers, or absurd ones */
    PlotPoint *best;          /* the front, the fastest first */
    uint32_t best_count;
    const char **methods; /* names, the chart's */
    int method_count;
    PlotLabel *labels;
    uint32_t label_count;
} Plot;

/* Lays out a chart in a box. errors GP_ERROR_MEMORY; owns: the caller, until plot_free */
GpResult plot_create(const Chart *chart, PlotBox box, Plot *plot);
void plot_free(Plot *plot);

#endif
