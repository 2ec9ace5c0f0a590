#include "apps/charts/svg.h"

#include <stdio.h>

const char svg_ink[] = "#1f2430", svg_soft[] = "#5b6472", svg_grid[] = "#e9ecf0",
           svg_frame[] = "#aab2bd";

const char svg_small_words[] =
    " font-size=\"11\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\" "
    "stroke-linejoin=\"round\"";

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

/* More series than shapes: the second round pairs them with other colours. */
static const char *shape_of(int series)
{
    return shapes[(size_t)series % GP_COUNT(shapes)];
}

const char *svg_color(int series)
{
    size_t number = (size_t)series;
    return colors[(number + number / GP_COUNT(shapes)) % GP_COUNT(colors)];
}

/* --- pieces ----------------------------------------------------------------------------------- */

void svg_begin(Text *svg, int width, int height, const char *title)
{
    text_add(svg,
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
             "height=\"%d\" role=\"img\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" "
             "font-size=\"12\">\n<title>",
             width, height, width, height);
    text_add_escaped(svg, title);
    text_add(svg,
             "</title>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n"
             "<g fill=\"%s\">\n",
             svg_ink);
}

void svg_end(Text *svg)
{
    text_add(svg, "</g>\n</svg>\n");
}

void svg_line(Text *svg, double x1, double y1, double x2, double y2, const char *color)
{
    text_add(svg, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1, y1,
             x2, y2, color);
}

void svg_dots(Text *svg, double x1, double y1, double x2, double y2)
{
    text_add(svg,
             "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
             "stroke-dasharray=\"2 4\"/>\n",
             x1, y1, x2, y2, svg_soft);
}

void svg_words(Text *svg, double x, double y, const char *anchor, const char *more,
               const char *content)
{
    text_add(svg, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", x, y, anchor, more);
    text_add_escaped(svg, content);
    text_add(svg, "</text>\n");
}

void svg_marker(Text *svg, double x, double y, int series, bool grey)
{
    text_add(svg,
             "<path d=\"%s\" transform=\"translate(%.1f %.1f)\" fill=\"%s\" stroke=\"%s\" "
             "stroke-width=\"1\"/>",
             shape_of(series), x, y, grey ? "#d3d8df" : svg_color(series),
             grey ? "#9ea7b3" : "#ffffff");
}

/* --- axes ------------------------------------------------------------------------------------- */

/* Where numbers and names stand, and how long ticks are. */
enum { TICK = 3, TICK_LABELLED = 6, NUMBER_BELOW = 21, NAME_BELOW = 44, NUMBER_LEFT = 10 };

/* "200", "1 million" */
static void number_of_tick(double tick, char number[32])
{
    bool millions = tick >= 999999 && tick < 999999999;
    snprintf(number, 32, millions ? "%g million" : "%g", millions ? tick * 1e-6 : tick);
}

void svg_axis_below(Text *svg, const PlotScale *scale, PlotBox box, const char *name)
{
    bool labelled;
    for (double tick = 0; (tick = plot_next_tick(scale, tick, &labelled)) > 0;) {
        double x = plot_place(scale, tick);
        char number[32];
        number_of_tick(tick, number);
        svg_line(svg, x, box.top, x, box.bottom, svg_grid);
        svg_line(svg, x, box.bottom, x, box.bottom + (labelled ? TICK_LABELLED : TICK), svg_frame);
        if (labelled)
            svg_words(svg, x, box.bottom + NUMBER_BELOW, "middle", "", number);
    }
    svg_words(svg, (box.left + box.right) / 2, box.bottom + NAME_BELOW, "middle",
              " font-size=\"14\"", name);
}

void svg_axis_left(Text *svg, const PlotScale *scale, PlotBox box, double name_x, const char *name)
{
    bool labelled;
    for (double tick = 0; (tick = plot_next_tick(scale, tick, &labelled)) > 0;) {
        double y = plot_place(scale, tick);
        char number[32];
        number_of_tick(tick, number);
        svg_line(svg, box.left, y, box.right, y, svg_grid);
        svg_line(svg, box.left - (labelled ? TICK_LABELLED : TICK), y, box.left, y, svg_frame);
        if (labelled)
            svg_words(svg, box.left - NUMBER_LEFT, y + 4, "end", "", number);
    }
    char turned[64];
    double middle = (box.top + box.bottom) / 2;
    snprintf(turned, sizeof turned, " font-size=\"14\" transform=\"rotate(-90 %.0f %.1f)\"", name_x,
             middle);
    svg_words(svg, name_x, middle, "middle", turned, name);
}

void svg_border(Text *svg, PlotBox box)
{
    text_add(svg,
             "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" "
             "stroke=\"%s\"/>\n",
             box.left, box.top, box.right - box.left, box.bottom - box.top, svg_frame);
}
