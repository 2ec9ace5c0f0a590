/* Points as voxels: given ones, or those of parametric surfaces, whose place the vertex shader
 * computes. Drawn as points into a whole flat texture, blended with GP_BLEND_LOGIC_OR. */
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

typedef struct VoxelParametricUniforms {
    VoxelPointsUniforms place;
    float radius, width;    /* of the surface, see there */
    float control[4][4][3]; /* of a patch: row by v, column by u */
} VoxelParametricUniforms;

/* GP_TEXCOORD0: (u, v), both from 0 to 1. y is up. */
extern const GpProgram voxel_sphere_program;  /* radius */
extern const GpProgram voxel_torus_program;   /* radius of the circle, width: radius of the tube */
extern const GpProgram voxel_moebius_program; /* radius of the circle, width of the band */
extern const GpProgram voxel_klein_program;   /* radius of the circle of a figure of eight 2 wide */
extern const GpProgram voxel_bezier_program;  /* a bicubic patch */

#endif
