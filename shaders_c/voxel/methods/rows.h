/* The inside of a model from the voxels where lines cross its surface: a scan of rows. */
#ifndef SHADERS_VOXEL_METHODS_ROWS_H
#define SHADERS_VOXEL_METHODS_ROWS_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/volume/flat_texture.h"

enum { VOXEL_ROWS_SLABS = 32 }; /* of 1024 voxels */

typedef struct VoxelRowsUniforms {
    FlatTextureLayout flat;            /* of 1 bit a voxel */
    float origin[VOXEL_ROWS_SLABS][2]; /* of each slab's patch, in texture space */
} VoxelRowsUniforms;

/* To be drawn over the whole of a flat texture. Slot 0: the flat texture of crossings. Slot 1: the
 * scan of eight voxels, 256 x 2: at (s, t) what byte s fills, begun outside (t = 0) or inside (1),
 * is red, and where it ends is green. Slot 2: what the first program made. */
extern const GpProgram voxel_row_ends_program; /* red: 1 where a texel's crossings are odd */
extern const GpProgram voxel_rows_program;     /* the inside */

#endif
