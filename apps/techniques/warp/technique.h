/* Depth images as the program knows them. */
#ifndef APPS_TECHNIQUES_WARP_TECHNIQUE_H
#define APPS_TECHNIQUES_WARP_TECHNIQUE_H

#include "apps/techniques/technique.h"

extern const Technique warp_technique;

#endif
