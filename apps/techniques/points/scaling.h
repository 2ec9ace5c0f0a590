/* How the time of points grows. */
#ifndef APPS_TECHNIQUES_POINTS_SCALING_H
#define APPS_TECHNIQUES_POINTS_SCALING_H

#include "apps/techniques/technique.h"

extern const TechniqueScaling points_scaling;

#endif
