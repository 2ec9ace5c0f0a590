#include "apps/techniques/voxel/methods/along.h"

#include <string.h>

void voxel_along_view(const VoxelModel *model, uint32_t size, int axis, bool from_far,
                      float matrix[4][4])
{
    const float per_voxel = 1.0f / (float)size;
    const float scale[3] = { 2 * per_voxel, -2 * per_voxel, from_far ? -per_voxel : per_voxel };
    const float offset[3] = { -1, 1, from_far ? 1 : 0 };
    memset(matrix, 0, sizeof(float[4][4]));
    for (int row = 0; row < 3; row++) {
        const float *voxel = model->motion.to_voxels[(axis + 1 + row) % 3];
        for (int k = 0; k < 4; k++)
            matrix[row][k] = voxel[k] * scale[row];
        matrix[row][3] += offset[row];
    }
    matrix[3][3] = 1;
}
