/* The set voxel nearest to a point, by a pyramid of volumes: a voxel of each is set where one of
 * eight below it is. */
#ifndef APPS_TRUTH_VOXEL_NEAREST_H
#define APPS_TRUTH_VOXEL_NEAREST_H

#include "pipeline/base/base.h"

enum { VOXEL_LEVELS = 12 }; /* up to 2048 voxels a side */

typedef struct VoxelPyramid {
    int levels;
    uint32_t size[VOXEL_LEVELS];       /* the last is 1 */
    const uint8_t *bits[VOXEL_LEVELS]; /* the first is borrowed */
} VoxelPyramid;

/* errors GP_ERROR_MEMORY; owns: the caller, until voxel_pyramid_free */
GpResult voxel_pyramid_make(const uint8_t *bits, uint32_t size, VoxelPyramid *pyramid);
void voxel_pyramid_free(VoxelPyramid *pyramid);

/* Distance in voxels of a point from the nearest centre of a set voxel; `most` where none is
 * nearer. */
double voxel_pyramid_nearest(const VoxelPyramid *pyramid, const double point[3], double most);

/* The first set bit from the i-th on; voxels in all where there is none. */
size_t voxel_next(const uint8_t *bits, uint32_t size, size_t i);

/* out  at: of voxel i, x first */
void voxel_place(size_t i, uint32_t size, uint32_t at[3]);

#endif
