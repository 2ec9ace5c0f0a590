/* Voxels as splats whose values are in a texture, which the vertex or the pixel shader reads (paper
 * 003's modes VT and PT). Places are those of a slice; slices lie side by side in a flat texture.
 * DEVIATES: the paper's proxies are indices into a template that all slices share, 4 bytes a voxel;
 * the places themselves take no more.
 */
#ifndef SHADERS_VOLUME_SPLAT_TEXTURE_H
#define SHADERS_VOLUME_SPLAT_TEXTURE_H

#include "shaders_c/volume/splat.h"

typedef struct VoxelTextureUniforms {
    VoxelUniforms voxel;
    float origin[3], across[3], down[3]; /* of the slice, in samples */
    float columns;                       /* slices z side by side in the texture */
    float size[2];                       /* of one of them, texels */
    float texel[2];                      /* 1 / width, 1 / height of the texture */
} VoxelTextureUniforms;

/* TEXCOORD0: across modulo 256, down modulo 256, across / 256, down / 256. Texture 0 as
 * voxel_ewa_program has it; texture 1, A8R8G8B8: gradient in red, green and blue, value in
 * alpha. */
extern const GpProgram voxel_vt_ewa_program, voxel_vt_reconstruction_program,
    voxel_vt_low_pass_program;
extern const GpProgram voxel_pt_ewa_program, voxel_pt_reconstruction_program,
    voxel_pt_low_pass_program;

#endif
