/* The box of a volume around a model. */
#include "apps/base/voxel_box.h"

#include <float.h>
#include <math.h>
#include <string.h>

VoxelBox voxel_box_of(const Bounds *bounds, uint32_t size)
{
    const double *low = bounds->low, *high = bounds->high, side = size - 2 * VOXEL_BOX_MARGIN;
    const double longest = bounds_longest(bounds);
    VoxelBox box = { .size = size, .scale = longest > 0 ? side / longest : 1 };
    for (int k = 0; k < 3; k++)
        box.offset[k] = size / 2.0 - box.scale * ((low[k] + high[k]) / 2);
    return box;
}

VoxelBox voxel_box(const float *positions, const uint32_t *indices, uint32_t count, uint32_t size)
{
    const Bounds bounds = bounds_of(positions, 3 * sizeof(float), indices, count);
    return voxel_box_of(&bounds, size);
}

bool voxel_box_is_usable(const VoxelBox *box)
{
    bool usable = box->scale >= (double)FLT_MIN && box->scale <= (double)FLT_MAX;
    for (int k = 0; k < 3; k++)
        usable &= fabs(box->offset[k]) <= (double)FLT_MAX;
    return usable;
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

size_t voxel_bytes(uint32_t size)
{
    return ((size_t)size * size * size + 7) / 8;
}
