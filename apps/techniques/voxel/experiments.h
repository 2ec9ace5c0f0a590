/* What charts draw of voxelization: surfaces and solids against their truths, since what is right
 * in one is wrong in the other; and how time grows. */
#ifndef APPS_TECHNIQUES_VOXEL_EXPERIMENTS_H
#define APPS_TECHNIQUES_VOXEL_EXPERIMENTS_H

#include "apps/techniques/technique.h"

extern const Experiment voxel_experiments[];
extern const TechniqueScaling voxel_scaling;

#endif
