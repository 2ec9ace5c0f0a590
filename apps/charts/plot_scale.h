/* Logarithmic axes of pictures: where a value lies, and which values have ticks. */
#ifndef APPS_CHARTS_PLOT_SCALE_H
#define APPS_CHARTS_PLOT_SCALE_H

#include "pipeline/base/base.h"

/* In pixels of the picture, y downwards. */
typedef struct PlotBox {
    double left, top, right, bottom;
} PlotBox;

/* A range of values, all positive, onto a range of places. */
typedef struct PlotScale {
    double low, high;  /* values */
    double begin, end; /* where they are */
    bool doubles;      /* ticks are powers of two, not of ten */
} PlotScale;

/* A scale of all values from low to high with some room at both ends; at least a factor of four.
 * Where low is above high, there are none: a scale about 1. */
PlotScale plot_scale(double low, double high, double begin, double end);

/* Place of a value. */
double plot_place(const PlotScale *scale, double value);

/* Next value above `value` (start with 0) that has a line of the grid; 0 where there is none.
 * out  labelled: whether its number is written */
double plot_next_tick(const PlotScale *scale, double value, bool *labelled);

bool plot_overlap(PlotBox a, PlotBox b);

#endif
