/* How a model comes into its volume: an affine map, then a twist. */
#ifndef SHADERS_VOXEL_METHODS_MOTION_H
#define SHADERS_VOXEL_METHODS_MOTION_H

typedef struct VoxelMotion {
    float to_voxels[4][4]; /* rows */
    float twist;           /* radians a voxel: turns about the vertical line through the centre */
    float centre;          /* of the volume, in voxels: half its size */
} VoxelMotion;

#endif
