/* Boxes of voxels: where a model may have any. */
#ifndef APPS_BASE_VOXEL_RANGE_H
#define APPS_BASE_VOXEL_RANGE_H

#include "pipeline/base/base.h"

/* Voxels of a box: low[k] <= voxel < end[k]. */
typedef struct VoxelRange {
    uint32_t low[3], end[3];
} VoxelRange;

/* All voxels that a model may touch.
 * in   low, high: its box; to_voxels: rows, affine */
VoxelRange voxel_range(const double low[3], const double high[3], float to_voxels[4][4],
                       uint32_t size);

/* All of a volume. */
VoxelRange voxel_range_whole(uint32_t size);

/* What two have in common; empty (an end that is not above low) where they are apart. */
VoxelRange voxel_range_common(const VoxelRange *a, const VoxelRange *b);
bool voxel_range_is_empty(const VoxelRange *range);

#endif
