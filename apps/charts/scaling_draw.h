/* Scaling as a picture: a panel for each thing that grows, time upwards, all axes logarithmic, so
 * that powers are straight lines. */
#ifndef APPS_CHARTS_SCALING_DRAW_H
#define APPS_CHARTS_SCALING_DRAW_H

#include "apps/base/text.h"
#include "apps/charts/scaling.h"

/* Appends the picture as SVG. */
void scaling_draw(const Scaling *scaling, Text *svg);

#endif
