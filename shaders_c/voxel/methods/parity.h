/* Solid voxels by parity: a voxel is inside where the number of surfaces above its centre is odd.
 * Each fragment turns over all bits below it. */
#ifndef SHADERS_VOXEL_METHODS_PARITY_H
#define SHADERS_VOXEL_METHODS_PARITY_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/methods/motion.h"

enum { VOXEL_PARITY_DEPTH = 128 }; /* voxels of a group: four targets of 32 bits */

/* Draws one group of slabs into four targets, a patch of size x size texels each at row `patch`. */
typedef struct VoxelParityUniforms {
    VoxelMotion motion;
    float size;           /* voxels a side */
    float patch, patches; /* which of how many, one below the other */
    float floor;          /* lowest voxel of the group */
    /* bits that a fragment may turn over: VOXEL_PARITY_DEPTH; beyond every volume for the top
     * group, which stands for all above it too */
    float most;
} VoxelParityUniforms;

/* To be blended with GP_BLEND_LOGIC_XOR. */
extern const GpProgram voxel_parity_program;

/* Copies a slab over the viewport, turned over where the number of fragments above its
 * group is odd: each of them turned over bit 0 of a group's lowest slab.
 * Slot 0: the slab's target; slot 1: target 0. */
typedef struct VoxelParityResolveUniforms {
    float patch, patches; /* of slot 0 and 1 */
} VoxelParityResolveUniforms;

/* To be drawn with flat_texture_cover. */
extern const GpProgram voxel_parity_resolve_program;

#endif
