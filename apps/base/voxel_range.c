/* Ranges of voxels, and what two have in common. */
#include "apps/base/voxel_range.h"

#include <math.h>

VoxelRange voxel_range(const double low[3], const double high[3], float to_voxels[4][4],
                       uint32_t size)
{
    const double margin = 1e-2; /* more than vertex shaders round by */
    VoxelRange range;
    for (int k = 0; k < 3; k++) {
        double least = (double)to_voxels[k][3], most = least;
        for (int i = 0; i < 3; i++) {
            const double one = (double)to_voxels[k][i] * low[i];
            const double other = (double)to_voxels[k][i] * high[i];
            least += one < other ? one : other;
            most += one < other ? other : one;
        }
        least = floor(least - margin);
        most = ceil(most + margin);
        range.low[k] = least < 0 ? 0 : least > size ? size : (uint32_t)least;
        range.end[k] = most < 0 ? 0 : most > size ? size : (uint32_t)most;
    }
    return range;
}

VoxelRange voxel_range_whole(uint32_t size)
{
    return (VoxelRange){ { 0, 0, 0 }, { size, size, size } };
}

VoxelRange voxel_range_common(const VoxelRange *a, const VoxelRange *b)
{
    VoxelRange common;
    for (int k = 0; k < 3; k++) {
        common.low[k] = a->low[k] > b->low[k] ? a->low[k] : b->low[k];
        common.end[k] = a->end[k] < b->end[k] ? a->end[k] : b->end[k];
    }
    return common;
}

bool voxel_range_is_empty(const VoxelRange *range)
{
    bool empty = false;
    for (int k = 0; k < 3; k++)
        empty |= range->low[k] >= range->end[k];
    return empty;
}
