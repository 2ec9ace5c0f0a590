/* Volumes as the program knows them. */
#ifndef APPS_TECHNIQUES_VOLUME_TECHNIQUE_H
#define APPS_TECHNIQUES_VOLUME_TECHNIQUE_H

#include "apps/techniques/technique.h"

extern const Technique volume_technique;

#endif
