/* Which blocks of 8 x 8 x 8 voxels have any, their neighbourhoods included: slices look there
 * first.
 *
 * A texel holds four blocks along z, not 0 where there is something: blue the first, then green,
 * red, alpha. It lies in column x + slab * columns, row y. */
#ifndef SHADERS_VOXEL_PICTURES_BLOCKS_H
#define SHADERS_VOXEL_PICTURES_BLOCKS_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/volume/flat_texture.h"

enum { VOXEL_BLOCK = 8 };

typedef struct VoxelBlocksUniforms {
    FlatTextureLayout flat;
    float columns;       /* blocks a side */
    float width, height; /* of what the second reads */
} VoxelBlocksUniforms;

/* One triangle around the target. First voxels next to each other along x become blocks, of one
 * flat texture or two, slots 0 and 1; then, of that in slot 0, those along y. Blocks reach a voxel
 * further on both sides, and along z as far as their neighbours do. */
extern const GpProgram voxel_block_rows_program;
extern const GpProgram voxel_blocks_program;

#endif
