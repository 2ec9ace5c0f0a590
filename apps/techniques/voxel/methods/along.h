/* What baselines draw with: a parallel view of the whole volume along an axis. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_ALONG_H
#define APPS_TECHNIQUES_VOXEL_METHODS_ALONG_H

#include "apps/techniques/voxel/methods/voxelize.h"

/* From the model to clip space, looking along an axis (0 x, 1 y, 2 z): the two axes that follow it,
 * in turn, run to the right and down over `size` voxels, and depth over the volume from 0 to 1, or
 * from 1 to 0 where it is counted from the far end.
 * out  matrix: rows */
void voxel_along_view(const VoxelModel *model, uint32_t size, int axis, bool from_far,
                      float matrix[4][4]);

#endif
