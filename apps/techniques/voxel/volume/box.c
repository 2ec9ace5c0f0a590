#include "apps/techniques/voxel/volume/box.h"

#include <math.h>
#include <string.h>

VoxelBounds voxel_bounds(const float *positions, const uint32_t *indices, uint32_t count)
{
    const double most = (double)INFINITY;
    VoxelBounds bounds = { { most, most, most }, { -most, -most, -most } };
    for (uint32_t i = 0; i < count; i++) {
        const float *p = positions + 3 * (size_t)(indices ? indices[i] : i);
        for (int k = 0; k < 3; k++) {
            const double at = (double)p[k];
            bounds.low[k] = at < bounds.low[k] ? at : bounds.low[k];
            bounds.high[k] = at > bounds.high[k] ? at : bounds.high[k];
        }
    }
    return bounds;
}

VoxelBox voxel_box_of(const VoxelBounds *bounds, uint32_t size)
{
    const double *low = bounds->low, *high = bounds->high, side = size - 2 * VOXEL_BOX_MARGIN;
    double longest = 0;
    for (int k = 0; k < 3; k++)
        longest = high[k] - low[k] > longest ? high[k] - low[k] : longest;

    VoxelBox box = { .size = size, .scale = longest > 0 ? side / longest : 1 };
    for (int k = 0; k < 3; k++)
        box.offset[k] = size / 2.0 - box.scale * ((low[k] + high[k]) / 2);
    return box;
}

VoxelBox voxel_box(const float *positions, const uint32_t *indices, uint32_t count, uint32_t size)
{
    const VoxelBounds bounds = voxel_bounds(positions, indices, count);
    return voxel_box_of(&bounds, size);
}

void voxel_box_matrix(const VoxelBox *box, float matrix[4][4])
{
    memset(matrix, 0, sizeof(float[4][4]));
    for (int k = 0; k < 3; k++) {
        matrix[k][k] = (float)box->scale;
        matrix[k][3] = (float)box->offset[k];
    }
    matrix[3][3] = 1;
}
