#include "apps/charts/scaling.h"

#include <math.h>

void scaling_free(Scaling *scaling)
{
    gp_free(scaling->points);
    *scaling = (Scaling){ .points = NULL };
}

const char *scaling_name(const Scaling *scaling, const ScalingPoint *point)
{
    return scaling->technique->scaling->panels[point->panel].lines[point->line].name;
}

bool scaling_has_place(const ScalingPoint *point)
{
    return point->amount > 0 && point->time.ms > 0 && isfinite(point->amount) &&
           isfinite(point->time.ms);
}

/* The point of a line with the least amount from `amount` on; of equal ones the first. */
static const ScalingPoint *next_larger(const Scaling *scaling, int panel, int line, double amount)
{
    const ScalingPoint *next = NULL;
    for (uint32_t i = 0; i < scaling->count; i++) {
        const ScalingPoint *point = &scaling->points[i];
        if (point->panel == panel && point->line == line && scaling_has_place(point) &&
            point->amount > 0 && point->amount >= amount && (!next || point->amount < next->amount))
            next = point;
    }
    return next;
}

/* Meshes of nearly as many triangles say nothing about a slope. */
static const double apart = 1.5;

bool scaling_power(const Scaling *scaling, int panel, int line, ScalingPower *power)
{
    double count = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (uint32_t i = 0; i < scaling->count; i++) {
        const ScalingPoint *point = &scaling->points[i];
        if (point->panel != panel || point->line != line || !scaling_has_place(point))
            continue;
        const double x = log(point->amount), y = log(point->time.ms);
        count++;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    ScalingPower found = { .least = HUGE_VAL, .most = -HUGE_VAL };
    const ScalingPoint *from = next_larger(scaling, panel, line, 0), *to = NULL;
    if (!from || !next_larger(scaling, panel, line, apart * from->amount))
        return false;
    for (; (to = next_larger(scaling, panel, line, apart * from->amount)); from = to) {
        const double step = log(to->time.ms / from->time.ms) / log(to->amount / from->amount);
        found.least = fmin(found.least, step);
        found.most = fmax(found.most, step);
    }
    found.power = (count * xy - x_sum * y_sum) / (count * xx - x_sum * x_sum);
    *power = found;
    return true;
}
