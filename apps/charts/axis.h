/* Logarithmic axes of pictures: where a value lies, which values have ticks, and how an axis is
 * drawn. */
#ifndef APPS_CHARTS_AXIS_H
#define APPS_CHARTS_AXIS_H

#include "apps/charts/svg.h"

/* In pixels of the picture, y downwards. */
typedef struct PlotBox {
    double left, top, right, bottom;
} PlotBox;

bool plot_overlap(PlotBox a, PlotBox b);

/* The least and the greatest of some values, all positive; zeroed: of none. */
typedef struct PlotRange {
    double low, high;
} PlotRange;

void plot_range_add(PlotRange *range, double value);

/* A range of values onto a range of places. */
typedef struct PlotScale {
    double low, high;  /* values */
    double begin, end; /* where they are */
    bool doubles;      /* ticks are powers of two, not of ten */
} PlotScale;

/* A scale of a range with some room at both ends; at least a factor of four. Of no values: about
 * 1. */
PlotScale plot_scale(PlotRange range, double begin, double end);

/* Place of a value. */
double plot_place(const PlotScale *scale, double value);

/* Next value above `value` (start with 0) that has a line of the grid; 0 where there is none.
 * out  labelled: whether its number is written */
double plot_next_tick(const PlotScale *scale, double value, bool *labelled);

/* The grid, the ticks, the numbers and the names of the axes below a box and left of it, and the
 * box's border.
 * in   name_x: where the left axis's name stands */
void plot_axes(Text *svg, PlotBox box, const PlotScale *x, const char *x_name, const PlotScale *y,
               const char *y_name, double name_x);

#endif
