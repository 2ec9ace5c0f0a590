/* How the time of fragments grows. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_SCALING_H
#define APPS_TECHNIQUES_FRAGMENTS_SCALING_H

#include "apps/techniques/technique.h"

extern const TechniqueScaling fragment_scaling;

#endif
