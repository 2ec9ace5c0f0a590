/* How the time of volumes grows. */
#ifndef APPS_TECHNIQUES_VOLUME_SCALING_H
#define APPS_TECHNIQUES_VOLUME_SCALING_H

#include "apps/techniques/technique.h"

extern const TechniqueScaling volume_scaling;

#endif
