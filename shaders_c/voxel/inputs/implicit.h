/* Solids and surfaces of polynomials: the sign of a function at every voxel of a texel. */
#ifndef SHADERS_VOXEL_INPUTS_IMPLICIT_H
#define SHADERS_VOXEL_INPUTS_IMPLICIT_H

#include "pipeline/shader/program.h"

enum { VOXEL_FUNCTION_DEGREE = 8, VOXEL_FUNCTION_SIDE = VOXEL_FUNCTION_DEGREE + 1 };

typedef struct VoxelImplicitUniforms {
    float size;             /* voxels a side */
    float first[3];         /* where in the volume the samples of the patch's first texel begin */
    float scale, offset[3]; /* from voxels to the function's space */
    float inside[32]; /* values below this are inside: 0, or -infinity past the volume's end */
    /* of z^k y^j x^i; i + j + k is at most the degree */
    float coefficient[VOXEL_FUNCTION_SIDE][VOXEL_FUNCTION_SIDE][VOXEL_FUNCTION_SIDE];
} VoxelImplicitUniforms;

/* Covers a patch: bits of samples that are inside. The second one writes them to two targets, for
 * GP_BLEND_LOGIC_OR and GP_BLEND_LOGIC_AND over the corners of voxels. */
extern const GpProgram voxel_implicit_program;
extern const GpProgram voxel_implicit_corner_program;

#endif
