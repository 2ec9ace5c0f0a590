/* Shadow maps as a technique: what may be set, what is swept, what is true. */
#ifndef APPS_STUDY_SHADOW_H
#define APPS_STUDY_SHADOW_H

#include "apps/technique.h"

extern const Technique shadow_technique;

#endif
