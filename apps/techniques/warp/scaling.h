/* How the time of warped depth images grows. */
#ifndef APPS_TECHNIQUES_WARP_SCALING_H
#define APPS_TECHNIQUES_WARP_SCALING_H

#include "apps/techniques/technique.h"

extern const TechniqueScaling warp_scaling;

#endif
