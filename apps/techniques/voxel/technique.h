/* Voxelization as a technique. */
#ifndef APPS_TECHNIQUES_VOXEL_TECHNIQUE_H
#define APPS_TECHNIQUES_VOXEL_TECHNIQUE_H

#include "apps/techniques/technique.h"

extern const Technique voxel_technique;

#endif
