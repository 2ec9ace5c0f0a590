#include "apps/charts/plot_scale.h"

#include <math.h>

PlotScale plot_scale(double low, double high, double begin, double end)
{
    if (!(low <= high))
        low = high = 1;
    double middle = sqrt(low) * sqrt(high), factor = pow(high / low, 0.56);
    if (factor < 2)
        factor = 2;
    return (
        PlotScale){ .low = middle / factor, .high = middle * factor, .begin = begin, .end = end };
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

bool plot_overlap(PlotBox a, PlotBox b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
