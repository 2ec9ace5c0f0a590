#include "apps/charts/plot.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* --- series ----------------------------------------------------------------------------------- */

/* Colours that differ for all kinds of eyes: Okabe and Ito's (without yellow), then Tol's muted. */
static const char *const colors[] = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#222222",
    "#332288", "#882255", "#117733", "#999933", "#aa4499", "#44aa99", "#661100",
};

/* Outlines about the origin, of similar weight: shapes tell methods apart in print. */
static const char *const shapes[] = {
    "M6 0A6 6 0 1 1 -6 0A6 6 0 1 1 6 0Z",                           /* circle */
    "M-5.3 -5.3H5.3V5.3H-5.3Z",                                     /* square */
    "M0 -7L6.6 4.8H-6.6Z",                                          /* triangle */
    "M0 -7.4L7 0L0 7.4L-7 0Z",                                      /* diamond */
    "M0 7L6.6 -4.8H-6.6Z",                                          /* triangle down */
    "M-2.2 -6.6H2.2V-2.2H6.6V2.2H2.2V6.6H-2.2V2.2H-6.6V-2.2H-2.2Z", /* plus */
    "M0 -7.6L2 -2.4L7.4 -2.3L3.1 1.1L4.6 6.4L0 3.3L-4.6 6.4L-3.1 1.1L-7.4 -2.3L-2 -2.4Z", /* star */
    "M-7 0L-3.5 -6H3.5L7 0L3.5 6H-3.5Z",                   /* hexagon */
    "M-6 -6H6L-6 6H6Z",                                    /* hourglass */
    "M7 0L-4.8 6.6V-6.6Z",                                 /* triangle right */
    "M-6 -3l3-3 3 3 3-3 3 3-3 3 3 3-3 3-3-3-3 3-3-3 3-3Z", /* cross */
    "M-7 0L4.8 6.6V-6.6Z",                                 /* triangle left */
    "M-6 -6V6L6 -6V6Z",                                    /* bow tie */
    "M0 -6.8L6.5 -2.1L4 5.5H-4L-6.5 -2.1Z",                /* pentagon */
};

int plot_series(const char **names, int *count, const char *name)
{
    for (int i = 0; i < *count; i++)
        if (strcmp(names[i], name) == 0)
            return i;
    names[*count] = name;
    return (*count)++;
}

/* More series than shapes: the second round pairs them with other colours. */
const char *plot_color(int series)
{
    size_t number = (size_t)series;
    return colors[(number + number / GP_COUNT(shapes)) % GP_COUNT(colors)];
}

void plot_marker(Text *svg, double x, double y, int series, bool grey)
{
    text_add(svg,
             "<path d=\"%s\" transform=\"translate(%.1f %.1f)\" fill=\"%s\" stroke=\"%s\" "
             "stroke-width=\"1\"/>",
             shapes[(size_t)series % GP_COUNT(shapes)], x, y, grey ? "#d3d8df" : plot_color(series),
             grey ? "#9ea7b3" : "#ffffff");
}

/* --- around a plot ---------------------------------------------------------------------------- */

void plot_begin(Text *svg, int width, int height, const char *title)
{
    text_add_escaped(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
        "height=\"%d\" role=\"img\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" "
        "font-size=\"12\">\n<title>%s</title>\n"
        "<style>.pane { visibility: hidden } .best:hover .pane, .best:focus .pane "
        "{ visibility: visible } .best:focus { outline: none } .best:focus > path "
        "{ stroke: currentColor; stroke-width: 2 }</style>\n"
        "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n<g fill=\"%s\">\n",
        width, height, width, height, title, svg_ink);
    svg_words(svg, PLOT_MARGIN, 48, "start",
              " class=\"title\" font-size=\"24\" font-weight=\"bold\"", title);
}

void plot_note(Text *svg, int line, const char *format, ...)
{
    char note[640];
    va_list args;
    va_start(args, format);
    vsnprintf(note, sizeof note, format, args);
    va_end(args);
    svg_words(svg, PLOT_MARGIN, 74 + 20 * line, "start", " font-size=\"13\"", note);
}

void plot_machine(Text *svg, int line, const char *scene, const PlotMachine *machine)
{
    const double busy = 0.1;
    plot_note(svg, line, "%sMeasured on %s, %s, %d thread%s.", scene, machine->machine,
              machine->isa, machine->threads, machine->threads == 1 ? "" : "s");
    if (machine->others >= busy)
        plot_note(svg, line + 1,
                  "The machine was busy: other programs kept %.1f processors at work meanwhile, so "
                  "that times are longer and spread wider.",
                  machine->others);
}

void plot_end(Text *svg, int height, const char *words)
{
    svg_words(svg, PLOT_MARGIN, height - 18, "start", " font-size=\"13\" font-style=\"italic\"",
              words);
    text_add(svg, "</g>\n</svg>\n");
}

void plot_tooltip_times(Text *svg, const Timing *time)
{
    char ms[32], least[32], most[32], cpu[32];
    text_for_people(time->ms, 3, ms);
    text_for_people(time->min_ms, 3, least);
    text_for_people(time->max_ms, 3, most);
    text_for_people(time->cpu_ms, 3, cpu);
    text_add(svg, "%s ms (", ms);
    if (time->max_ms > 0)
        text_add(svg, "%s to %s", least, most);
    else
        text_add(svg, "least %s", least);
    text_add(svg, ", processor %s; %u frames)", cpu, time->frames);
}
