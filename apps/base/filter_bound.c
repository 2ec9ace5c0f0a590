#include "apps/base/filter_bound.h"

#include "apps/base/stable_math.h"

#include <math.h>

static double relative_entropy(double t)
{
    return t > 0 ? t - 1 - stable_log(t) : (double)INFINITY;
}

static double bound(double t1, double t2)
{
    return sqrt(fmax(relative_entropy(t1) + relative_entropy(t2), 0));
}

double filter_bound_reconstruction(double l1, double l2, double h)
{
    return h > 0 ? bound(l1 / (l1 + h), l2 / (l2 + h)) : 0;
}

double filter_bound_low_pass(double l1, double l2, double h)
{
    return l1 > 0 ? bound(h / (l1 + h), h / (l2 + h)) : 0;
}
