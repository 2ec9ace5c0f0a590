/* One slice of a volume: what the clip planes leave of the model sets one bit. */
#ifndef SHADERS_VOXEL_SLICE_H
#define SHADERS_VOXEL_SLICE_H

#include "pipeline/program.h"

typedef struct VoxelSliceUniforms {
    float to_clip[4][4]; /* model to clip space, looking along z */
    float bit[4];        /* the slice's, red green blue alpha / 255 */
} VoxelSliceUniforms;

/* Blended with GP_BLEND_LOGIC_OR, or _XOR for solids. */
extern const GpProgram voxel_slice_program;

#endif
