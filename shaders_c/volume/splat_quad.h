/* Voxels as splats of four vertices each: what paper 003 compares its point sprites with (QD). */
#ifndef SHADERS_VOLUME_SPLAT_QUAD_H
#define SHADERS_VOLUME_SPLAT_QUAD_H

#include "shaders_c/volume/splat.h"

/* Triangles; inputs and textures of voxel_ewa_program, four times, and TEXCOORD2: the corner, 0 or
 * 1 to the right and down. */
extern const GpProgram voxel_qd_ewa_program, voxel_qd_reconstruction_program,
    voxel_qd_low_pass_program;

#endif
