/* Where a picture is wrong, to be seen: see chart_pictures.h. */
#ifndef APPS_CHARTS_CHART_DIFFERENCE_H
#define APPS_CHARTS_CHART_DIFFERENCE_H

#include "apps/frame/picture.h"

/* Makes the picture of a difference, twice as wide as what it is of.
 * in   picture: of any colour format, seen clamped to [0, 1]; off: [height][width]
 * errors GP_ERROR_MEMORY; owns: the caller, until picture_free */
GpResult chart_difference(const GpSurface *picture, const float *off, Picture *made,
                          GpError *error);

#endif
