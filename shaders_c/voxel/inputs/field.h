/* Solids and surfaces of functions that were sampled before: a volume of floats, four along z in
 * each texel, in patches as flat textures have them. */
#ifndef SHADERS_VOXEL_INPUTS_FIELD_H
#define SHADERS_VOXEL_INPUTS_FIELD_H

#include "pipeline/shader/program.h"

enum { VOXEL_FIELD_PATCHES = 9 }; /* that hold the samples 0..32 of a column */

typedef struct VoxelFieldUniforms {
    float size;                           /* voxels a side */
    float origin[VOXEL_FIELD_PATCHES][2]; /* first texel of each patch of samples */
    float texel[2];                       /* 1 / the texture's width and height */
    float next;                           /* 0, or 1: begin with the second sample */
    float inside[32]; /* values below this are inside: 0, or -infinity past the volume's end */
} VoxelFieldUniforms;

/* Slot 0: the samples. As implicit.h. */
extern const GpProgram voxel_field_program;
extern const GpProgram voxel_field_corner_program;

#endif
