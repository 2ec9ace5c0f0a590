/* Parametric surfaces as voxels: points whose place the vertex shader computes. Drawn as points
 * into a whole flat texture, blended with GP_BLEND_LOGIC_OR. */
#ifndef SHADERS_VOXEL_INPUTS_PARAMETRIC_H
#define SHADERS_VOXEL_INPUTS_PARAMETRIC_H

#include "shaders_c/voxel/inputs/points.h"

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
