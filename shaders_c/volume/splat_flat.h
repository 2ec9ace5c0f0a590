/* Voxels as splats, of which those that hardly let light through lie flat in the surface of equal
 * values that they are part of; the others are round.
 *
 * A kernel of variance S is flattened along the normal n to S - f (S n)(S n)^T / (n^T S n): its
 * extent along n becomes sqrt(1 - f) of what it was, and nothing else changes.
 * source paper 003, 4.1.4; Zwicker et al., "EWA volume splatting", Visualization 2001, section 5
 */
#ifndef SHADERS_VOLUME_SPLAT_FLAT_H
#define SHADERS_VOLUME_SPLAT_FLAT_H

#include "shaders_c/volume/splat.h"

typedef struct VoxelFlatUniforms {
    VoxelUniforms voxel;
    float opaque;   /* strength from which on voxels are flat */
    float flatness; /* f */
} VoxelFlatUniforms;

/* Inputs and textures of voxel_ewa_program. (The low-pass filter alone has no shape to flatten.) */
extern const GpProgram voxel_flat_ewa_program, voxel_flat_reconstruction_program;

#endif
