/* Meshes of which all fragments count as the program knows them. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_TECHNIQUE_H
#define APPS_TECHNIQUES_FRAGMENTS_TECHNIQUE_H

#include "apps/techniques/technique.h"

extern const Technique fragment_technique;

#endif
