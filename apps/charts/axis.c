#include "apps/charts/axis.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool plot_overlap(PlotBox a, PlotBox b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

void plot_range_add(PlotRange *range, double value)
{
    range->low = range->high > 0 ? fmin(range->low, value) : value;
    range->high = fmax(range->high, value);
}

PlotScale plot_scale(PlotRange range, double begin, double end)
{
    if (!(range.high > 0))
        range = (PlotRange){ 1, 1 };
    double centre = sqrt(range.low) * sqrt(range.high), factor = pow(range.high / range.low, 0.56);
    if (factor < 2)
        factor = 2;
    return (
        PlotScale){ .low = centre / factor, .high = centre * factor, .begin = begin, .end = end };
}

double plot_place(const PlotScale *scale, double value)
{
    double share = log(value / scale->low) / log(scale->high / scale->low);
    return scale->begin + share * (scale->end - scale->begin);
}

static double next_power_of_two(const PlotScale *scale, double from, bool *labelled)
{
    double tick = exp2(ceil(log2(from)));
    *labelled = true;
    return tick <= scale->high ? tick : 0;
}

double plot_next_tick(const PlotScale *scale, double value, bool *labelled)
{
    double decades = log10(scale->high / scale->low);
    double from = value > 0 ? value * 1.001 : scale->low;
    if (scale->doubles)
        return next_power_of_two(scale, from, labelled);
    for (double power = pow(10, floor(log10(from))); power <= scale->high; power *= 10) {
        for (int digit = 1; digit <= 9; digit++) {
            double tick = digit * power;
            if (tick < from || tick > scale->high)
                continue;
            bool round = digit == 1 || digit == 2 || digit == 5;
            *labelled = decades < 1.2 || digit == 1 || (round && decades < 4);
            return tick;
        }
    }
    return 0;
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* Where numbers and names stand, and how long ticks are. */
enum { TICK = 3, TICK_LABELLED = 6, NUMBER_BELOW = 21, NAME_BELOW = 44, NUMBER_LEFT = 10 };

static const char name_style[] = " font-size=\"14\"";

/* "200", "1 million" */
static void number_of_tick(double tick, char number[32])
{
    const bool millions = tick >= 999999 && tick < 999999999;
    text_for_people(millions ? tick * 1e-6 : tick, 3, number);
    if (millions)
        strcat(number, " million");
}

static void draw_ticks(Text *svg, PlotBox box, const PlotScale *scale, bool below)
{
    bool labelled;
    for (double tick = 0; (tick = plot_next_tick(scale, tick, &labelled)) > 0;) {
        const double at = plot_place(scale, tick), length = labelled ? TICK_LABELLED : TICK;
        char number[32] = "";
        if (labelled)
            number_of_tick(tick, number);
        if (below) {
            svg_line(svg, at, box.top, at, box.bottom, svg_grid);
            svg_line(svg, at, box.bottom, at, box.bottom + length, svg_frame);
            svg_words(svg, at, box.bottom + NUMBER_BELOW, "middle", "", number);
        } else {
            svg_line(svg, box.left, at, box.right, at, svg_grid);
            svg_line(svg, box.left - length, at, box.left, at, svg_frame);
            svg_words(svg, box.left - NUMBER_LEFT, at + 4, "end", "", number);
        }
    }
}

void plot_axes(Text *svg, PlotBox box, const PlotScale *x, const char *x_name, const PlotScale *y,
               const char *y_name, double name_x)
{
    char turned[64];
    const double centre = (box.top + box.bottom) / 2;
    snprintf(turned, sizeof turned, "%s transform=\"rotate(-90 %.0f %.1f)\"", name_style, name_x,
             centre);
    draw_ticks(svg, box, x, true);
    svg_words(svg, (box.left + box.right) / 2, box.bottom + NAME_BELOW, "middle", name_style,
              x_name);
    draw_ticks(svg, box, y, false);
    svg_words(svg, name_x, centre, "middle", turned, y_name);
    svg_rectangle(svg, box.left, box.top, box.right - box.left, box.bottom - box.top, "none",
                  svg_frame);
}
