/* What charts of all kinds have in common: series of points, and the words around a plot. */
#ifndef APPS_CHARTS_PLOT_H
#define APPS_CHARTS_PLOT_H

#include "apps/charts/axis.h"
#include "apps/frame/timing.h"

enum { PLOT_MARGIN = 32 };

/* The number of a name in a list, in which it is then, if it was not before. in names: room for
 * it */
int plot_series(const char **names, int *count, const char *name);

/* The colour of a series, and its shape: the first fourteen differ in both. */
const char *plot_color(int series);

/* grey: without its colour */
void plot_marker(Text *svg, double x, double y, int series, bool grey);

/* A picture on white with its title, lines of notes below that, and words at its lower edge. */
void plot_begin(Text *svg, int width, int height, const char *title);
void plot_note(Text *svg, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* By what times were measured. */
typedef struct PlotMachine {
    const char *machine, *isa;
    int threads;
    double others; /* processors that other programs kept busy; below 0: unknown */
} PlotMachine;

/* A note on that, behind words of the caller's own; a second one where the machine was busy. */
void plot_machine(Text *svg, int line, const char *scene, const PlotMachine *machine);

void plot_end(Text *svg, int height, const char *words);

/* A line of a tooltip. */
void plot_tooltip_times(Text *svg, const Timing *time);

#endif
