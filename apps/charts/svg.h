/* Pieces of pictures with axes, as SVG: what charts of all kinds share. */
#ifndef APPS_CHARTS_SVG_H
#define APPS_CHARTS_SVG_H

#include "apps/charts/plot_scale.h"
#include "apps/base/text.h"

extern const char svg_ink[], svg_soft[], svg_grid[], svg_frame[]; /* colours */

/* Begins a picture on white; svg_end ends it. */
void svg_begin(Text *svg, int width, int height, const char *title);
void svg_end(Text *svg);

void svg_line(Text *svg, double x1, double y1, double x2, double y2, const char *color);

/* The same in dots, to compare with. */
void svg_dots(Text *svg, double x1, double y1, double x2, double y2);

/* anchor: start, middle or end; more: further attributes */
void svg_words(Text *svg, double x, double y, const char *anchor, const char *more,
               const char *content);

/* Attributes of words that lie over lines: a white edge. */
extern const char svg_small_words[];

/* The colour of a series, and its shape: the first fourteen differ in both. */
const char *svg_color(int series);

/* grey: without its colour */
void svg_marker(Text *svg, double x, double y, int series, bool grey);

/* The grid, the ticks, the numbers and the name of an axis below a box, or left of it. */
void svg_axis_below(Text *svg, const PlotScale *scale, PlotBox box, const char *name);
void svg_axis_left(Text *svg, const PlotScale *scale, PlotBox box, double name_x, const char *name);

void svg_border(Text *svg, PlotBox box);

#endif
