/* Triangles into slabs of voxels along an axis, four slabs at once, one in each target: a fragment
 * adds, or takes the greatest of, what it has to say to its voxel's part of the texel. */
#ifndef SHADERS_VOXEL_METHODS_SHEETS_H
#define SHADERS_VOXEL_METHODS_SHEETS_H

#include "pipeline/shader/program.h"

typedef struct VoxelSheetsUniforms {
    float to_flat[4][4]; /* rows: from the model to u, v and depth in voxels */
    float size;          /* voxels a side */
    float first_slab;    /* of target 0 */

    /* of many-valued voxels: numbers of up to 16 bits, low byte first */
    float to_volume[4][4]; /* rows: from the model to x, y, z in voxels, for normals */
    float per_texel;
    float voxel_of[4];        /* by channel, red first: which voxel of the texel it is part of */
    float low[4], high[4];    /* by channel: 1 where it is that voxel's low, high byte */
    float levels[3];          /* a number 0..1 becomes a whole one up to this */
    float weights[3], offset; /* the value is offset + the sum of these times those */
} VoxelSheetsUniforms;

/* Slot 0: the powers of two, 2^s / 255 at texel s of 8. */
extern const GpProgram voxel_bits_program; /* bits: GP_BLEND_ADD as printed, or GP_BLEND_LOGIC_OR */

/* Many values: GP_BLEND_ADD with a weight, or GP_BLEND_MAX. */
extern const GpProgram voxel_density_program; /* the offset, in every fragment */
extern const GpProgram voxel_normals_program; /* two numbers, of the octahedron unfolded */
extern const GpProgram voxel_colors_program;  /* red, green, blue */

#endif
