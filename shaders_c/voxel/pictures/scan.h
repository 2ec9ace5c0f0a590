/* Scanned volumes, of a byte a voxel: their slopes, and slices through them. */
#ifndef SHADERS_VOXEL_PICTURES_SCAN_H
#define SHADERS_VOXEL_PICTURES_SCAN_H

#include "shaders_c/voxel/pictures/view.h"

typedef struct VoxelSlopesUniforms {
    FlatTextureLayout scan, slopes;
} VoxelSlopesUniforms;

/* One triangle around a flat texture of one voxel a texel: red, green and blue are the direction in
 * which samples fall off, alpha is the sample. Slot 0: the scan, read by points. */
extern const GpProgram voxel_slopes_program;

typedef struct VoxelScanUniforms {
    VoxelViewUniforms view; /* of the voxels; thickness and the rest of the scan too */
    FlatTextureLayout slopes;
    float light[3];  /* towards it, unit length; x, y, z */
    float to_eye[3]; /* from the volume's centre */
} VoxelScanUniforms;

/* Slices as voxel_view's. Slot 1: the slopes, read linearly; slot 2: the transfer ramp, 256 texels:
 * colour and the share of light that is lost on a way of one voxel. */
extern const GpProgram voxel_scan_program;
/* The same among voxels of slot 0, which may let light through. */
extern const GpProgram voxel_scan_mixed_program;

#endif
