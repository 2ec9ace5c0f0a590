/* Shadow maps as a technique: what may be set, what is swept, what is true. */
#ifndef APPS_TECHNIQUES_SHADOW_TECHNIQUE_H
#define APPS_TECHNIQUES_SHADOW_TECHNIQUE_H

#include "apps/techniques/technique.h"

extern const Technique shadow_technique;

#endif
