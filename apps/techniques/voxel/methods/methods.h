/* The methods of voxelization, each in a file of its own: columns.c (conservative and thin), xor.c,
 * winding.c, sheets.c (as printed), slices.c, layered_depth.c and faces.c. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_METHODS_H
#define APPS_TECHNIQUES_VOXEL_METHODS_METHODS_H

#include "apps/techniques/voxel/methods/model.h"
#include "apps/techniques/voxel/methods/setting.h"
#include "apps/techniques/voxel/volume/flat_texture.h"

/* Appends the passes of a method to a frame.
 * in   setting: has been checked, and says which method (no VOXEL_AUTO)
 * out  volume: its texels are right once the list has run */
typedef void VoxelMethodPasses(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                               const FlatTexture *volume);

VoxelMethodPasses voxel_columns, voxel_xor, voxel_winding, voxel_sheets, voxel_slices,
    voxel_layered_depth, voxel_faces;

/* Surfaces that lie behind so many others are lost by layered depth images. Even, so that what is
 * left of a solid ends at a surface. */
enum { VOXEL_LAYERS = 16 };

#endif
