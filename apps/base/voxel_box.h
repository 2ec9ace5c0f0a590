/* Where a volume lies in its model's space. */
#ifndef APPS_BASE_VOXEL_BOX_H
#define APPS_BASE_VOXEL_BOX_H

#include "apps/base/bounds.h"

#include <stdbool.h>

/* From the model's space to voxels: q = scale * p + offset; voxel (x, y, z) is the cube from
 * (x, y, z) to (x+1, y+1, z+1). */
typedef struct VoxelBox {
    uint32_t size; /* voxels a side */
    double scale, offset[3];
} VoxelBox;

/* Empty around a model, in voxels: along its longest side. */
#define VOXEL_BOX_MARGIN 1.25

/* The bounds fill size - 2.5 voxels along their longest side, and lie in the centre; without extent
 * the scale is 1. */
VoxelBox voxel_box_of(const Bounds *bounds, uint32_t size);

/* That of vertices; see bounds_of. */
VoxelBox voxel_box(const float *positions, const uint32_t *indices, uint32_t count, uint32_t size);

/* Whether shaders can have the map: its scale is a normal float, and its offset one at all. */
bool voxel_box_is_usable(const VoxelBox *box);

/* The same map as a matrix of rows, for shaders. */
void voxel_box_matrix(const VoxelBox *box, float matrix[4][4]);

/* Bytes of a volume's bits: that of voxel (x, y, z) is i = x + size (y + size z), bit i % 8 of byte
 * i / 8 from the low end. */
size_t voxel_bytes(uint32_t size);

#endif
