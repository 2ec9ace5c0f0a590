/* Constructive solid geometry and collision of volumes: flat textures blended into one another. */
#ifndef APPS_TECHNIQUES_VOXEL_VOLUME_COMBINE_H
#define APPS_TECHNIQUES_VOXEL_VOLUME_COMBINE_H

#include "apps/base/voxel_range.h"
#include "apps/techniques/voxel/volume/flat_texture.h"

typedef enum VoxelCombine {
    VOXEL_UNION,
    VOXEL_INTERSECTION,
    VOXEL_DIFFERENCE,
    VOXEL_TOUCHING, /* of voxel_collide: what both have, and both can be shown */
} VoxelCombine;

/* Appends the passes that make result = a OP b: with one bit a voxel of the bits, with eight of
 * densities, the greater, the lesser, and the lesser of a and what b leaves to 255.
 * in   operation: not VOXEL_TOUCHING
 *      a, b, result: of one layout, 1 or 8 bits; b is not the result. Where a is the result it is
 *      changed in place, by half the work
 *      where b was drawn by the list's last passes it is still in the tiles, and not read again
 * source Dong et al., Pacific Graphics 2004: CSG as blending of flat textures. DEVIATES: blending
 *      there adds, and is right only where no voxel is set twice; logical operations are right
 *      everywhere */
void voxel_combine(Frame *frame, const FlatTexture *a, const FlatTexture *b, VoxelCombine operation,
                   const FlatTexture *result);

/* Appends the passes that leave in result, inside `common`, the voxels which both a and b have. As
 * two objects meet nowhere else, what lies outside is neither looked at nor changed, but for voxels
 * that share a texel with others inside.
 * in   a, b, result: of one layout, 1 bit; b is not the result. Where a is the result, as a moving
 *      object's flat texture may be once the picture is drawn, it is changed in place, by half the
 *      work */
void voxel_collide(Frame *frame, const FlatTexture *a, const FlatTexture *b,
                   const VoxelRange *common, const FlatTexture *result);

#endif
