/* What the names in charts of voxelization mean. */
#ifndef APPS_TECHNIQUES_VOXEL_WORDS_H
#define APPS_TECHNIQUES_VOXEL_WORDS_H

#include "apps/techniques/technique.h"

extern const TechniqueWord voxel_surface_words[], voxel_solid_words[], voxel_scaling_words[];
extern const char voxel_surface_truth[], voxel_solid_truth[];

#endif
