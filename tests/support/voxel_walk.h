/* The voxels along a ray, in order, in double: what slices are compared with. */
#ifndef TESTS_VOXEL_WALK_H
#define TESTS_VOXEL_WALK_H

#include "pipeline/base/base.h"

typedef struct VoxelStep {
    uint32_t voxel[3];
    double enter, leave; /* along the ray, in its direction's lengths; enter >= 0 */
} VoxelStep;

/* Voxels of a volume that a ray goes through, by sorting where it meets planes between voxels.
 * in     direction: not 0
 * out    steps: [3 * size + 1]
 * returns how many */
uint32_t voxel_walk(uint32_t size, const double origin[3], const double direction[3],
                    VoxelStep *steps);

#endif
