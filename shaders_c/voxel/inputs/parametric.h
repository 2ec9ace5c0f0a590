/* The voxels that a parametric surface touches: triangles of a grid, whose corners the vertex
 * shader computes, set those that they touch (columns.h), and those beside them as far as the
 * surface may be from its triangles. Drawn as points, one a triangle, into a whole flat texture,
 * blended with GP_BLEND_LOGIC_OR. */
#ifndef SHADERS_VOXEL_INPUTS_PARAMETRIC_H
#define SHADERS_VOXEL_INPUTS_PARAMETRIC_H

#include "shaders_c/voxel/methods/columns.h"

/* Voxels are wider by this to each side than they are, where triangles are held against them. */
#define VOXEL_PARAMETRIC_MARGIN (1.0f / 128)

typedef struct VoxelParametricUniforms {
    VoxelColumnsUniforms columns;
    float radius, width;    /* of the surface, see there */
    float control[4][4][3]; /* of a patch: row by v, column by u */
} VoxelParametricUniforms;

/* GP_TEXCOORD0 to 2: (u, v) of a triangle's corners, both from 0 to 1. y is up. */
extern const GpProgram voxel_sphere_program;  /* radius */
extern const GpProgram voxel_torus_program;   /* radius of the circle, width: radius of the tube */
extern const GpProgram voxel_moebius_program; /* radius of the circle, width of the band */
extern const GpProgram voxel_klein_program;   /* radius of the circle of a figure of eight 2 wide */
extern const GpProgram voxel_bezier_program;  /* a bicubic patch */

#endif
