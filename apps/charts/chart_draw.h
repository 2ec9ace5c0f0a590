/* A chart as a picture: time against error, both logarithmic, a shape and a colour for each method,
 * the front as a line of steps, and all other points in grey. */
#ifndef APPS_CHARTS_CHART_DRAW_H
#define APPS_CHARTS_CHART_DRAW_H

#include "apps/base/text.h"
#include "apps/charts/chart.h"

/* Appends the chart as an SVG element that needs nothing but itself. */
void chart_draw(const Chart *chart, Text *svg);

#endif
