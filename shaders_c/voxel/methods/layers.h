/* Layered depth images: a model's surfaces along z, peeled off one by one, and the voxels between
 * them. */
#ifndef SHADERS_VOXEL_METHODS_LAYERS_H
#define SHADERS_VOXEL_METHODS_LAYERS_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/volume/flat_texture.h"

typedef struct VoxelPeelUniforms {
    float to_clip[4][4]; /* model to clip space, looking along z; w stays 1 */
} VoxelPeelUniforms;

/* The nearest depth, in an R32F target cleared to VOXEL_NO_LAYER and with a depth buffer; the
 * second one beyond the layer in slot 0. */
extern const GpProgram voxel_peel_first_program;
extern const GpProgram voxel_peel_next_program;

/* Where there is no surface any more: beyond all depths. */
#define VOXEL_NO_LAYER 2.0f

/* Covers a patch, with FlatTextureSlab for uniforms, blended with GP_BLEND_LOGIC_OR: the voxel of
 * the depth in slot 0; those whose centres lie between slots 0 and 1, none where slot 1 has no
 * layer. */
extern const GpProgram voxel_layer_program;
extern const GpProgram voxel_between_program;

#endif
