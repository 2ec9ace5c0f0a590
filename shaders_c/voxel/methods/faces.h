/* Voxels that lie between what the six faces of the volume see. */
#ifndef SHADERS_VOXEL_METHODS_FACES_H
#define SHADERS_VOXEL_METHODS_FACES_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/volume/flat_texture.h"

/* Covers a patch, with FlatTextureSlab for uniforms. Slot 2 a: depth seen along axis a, 2 a + 1:
 * seen the other way, from there. */
extern const GpProgram voxel_faces_program;

#endif
