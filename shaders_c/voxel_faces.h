/* Voxels that lie between what the six faces of the volume see. */
#ifndef SHADERS_VOXEL_FACES_H
#define SHADERS_VOXEL_FACES_H

#include "pipeline/program.h"

typedef struct VoxelFacesUniforms {
    float size; /* voxels a side */
    float base; /* the first voxel of the slab along z */
} VoxelFacesUniforms;

/* Covers a patch. Slot 2 a: depth seen along axis a, 2 a + 1: seen the other way, from there. */
extern const GpProgram voxel_faces_program;

#endif
