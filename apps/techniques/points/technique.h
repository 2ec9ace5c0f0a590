/* Points: the technique, as registry.c knows it. */
#ifndef APPS_TECHNIQUES_POINTS_TECHNIQUE_H
#define APPS_TECHNIQUES_POINTS_TECHNIQUE_H

#include "apps/techniques/technique.h"

extern const Technique points_technique;

#endif
