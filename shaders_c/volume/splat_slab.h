/* Voxels as splats that are cut into slabs of equal depth: what of a kernel lies in the slab.
 *
 * Of a Gaussian that is cut at `cut` deviations, between depths z0 and z1, lies F(z1) - F(z0),
 * where F is its integral; of slabs that follow each other the shares add up to 1.
 * source Mueller and Crawfis, "Eliminating popping artifacts in sheet buffer-based splatting",
 *        Visualization 1998; the integral as a logistic function: Bowling et al., "A logistic
 *        approximation to the cumulative normal distribution", 2009, within 1.4e-4
 */
#ifndef SHADERS_VOLUME_SPLAT_SLAB_H
#define SHADERS_VOLUME_SPLAT_SLAB_H

#include "shaders_c/volume/splat.h"

typedef struct VoxelSlabUniforms {
    VoxelUniforms voxel;
    float begin, end;     /* of the slab, in deviations of the kernel along the view */
    float per_deviation;  /* 1 / that deviation */
    float low, per_whole; /* F before it is cut: at -cut, and 1 / what it is more at cut */
} VoxelSlabUniforms;

/* Inputs and textures of voxel_ewa_program. */
extern const GpProgram voxel_slab_ewa_program, voxel_slab_reconstruction_program,
    voxel_slab_low_pass_program;

#endif
