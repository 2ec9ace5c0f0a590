/* Given points as voxels. Drawn as points into a whole flat texture, blended with
 * GP_BLEND_LOGIC_OR. */
#ifndef SHADERS_VOXEL_INPUTS_POINTS_H
#define SHADERS_VOXEL_INPUTS_POINTS_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/volume/flat_texture.h"

typedef struct VoxelPointsUniforms {
    FlatTextureLayout flat;
    float scale, offset[3]; /* voxels = scale * position + offset */
} VoxelPointsUniforms;

/* GP_POSITION: the points. */
extern const GpProgram voxel_points_program;

#endif
