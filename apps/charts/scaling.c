#include "apps/charts/scaling.h"

void scaling_free(Scaling *scaling)
{
    gp_free(scaling->points);
    *scaling = (Scaling){ .points = NULL };
}

const char *scaling_name(const Scaling *scaling, const ScalingPoint *point)
{
    return scaling->technique->scaling->panels[point->panel].lines[point->line].name;
}
