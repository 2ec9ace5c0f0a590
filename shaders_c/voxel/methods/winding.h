/* Solid voxels by the winding number: what is above a voxel's centre counts 1 where its outside
 * faces up, and -1 where it faces down. A voxel is a channel of a target, which fragments add to
 * and, drawn with the other facing, subtract from; 16 voxels are a group of four targets. */
#ifndef SHADERS_VOXEL_METHODS_WINDING_H
#define SHADERS_VOXEL_METHODS_WINDING_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/methods/motion.h"

enum { VOXEL_WINDING_DEPTH = 16 }; /* voxels of a group: four targets of four channels */

/* Draws one group into four targets of size x size texels: voxel k of the group is red, green,
 * blue, alpha of target k / 4. */
typedef struct VoxelWindingUniforms {
    VoxelMotion motion;
    float size;  /* voxels a side */
    float floor; /* lowest voxel of the group */
    /* voxels that a fragment may count in: VOXEL_WINDING_DEPTH; beyond every volume for the top
     * group, which stands for all above it too */
    float most;
    float one; /* what is added: 1 of floats, 1/255 of bytes */
} VoxelWindingUniforms;

/* To be blended with GP_BLEND_ADD and GP_BLEND_REV_SUBTRACT, both factors one. */
extern const GpProgram voxel_winding_program;

/* Texels as numbers: scale * texel - zero. */
typedef struct VoxelWindingCounts {
    float scale, zero; /* 1, 0 of floats; 255 and what stands for none of bytes */
} VoxelWindingCounts;

/* A slab of 32 voxels over the viewport, whose bits are set where the number is not 0. Slots 0 to
 * 3: targets of its lower group; 4 to 7: of its upper group; 8: the sum of all groups above the
 * slab, as a number. To be drawn with flat_texture_cover. */
extern const GpProgram voxel_winding_slab_program;

/* That sum for the slab below, in red: each fragment of a group counts in its lowest voxel. Slots 0
 * and 1: the first targets of its lower and upper group; 2: the sum above. */
extern const GpProgram voxel_winding_sum_program;

#endif
