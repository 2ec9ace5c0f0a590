/* Voxelization: models into volumes, by passes that end in a flat texture. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_VOXELIZE_H
#define APPS_TECHNIQUES_VOXEL_METHODS_VOXELIZE_H

#include "apps/techniques/voxel/methods/model.h"
#include "apps/techniques/voxel/methods/setting.h"
#include "apps/techniques/voxel/volume/flat_texture.h"

/* The setting with the method that it means. */
VoxelSetting voxel_complete(const VoxelSetting *setting);

/* Appends the passes of a setting.
 * in     volume: of the setting's size and bits; its texels are right once the list has run
 * errors GP_ERROR_INVALID: the setting contradicts itself, with the reason; GP_ERROR_MEMORY */
GpResult voxel_draw(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                    const FlatTexture *volume, GpError *error);

/* The same into a flat texture that is made for it.
 * errors also those of flat_texture_check */
GpResult voxel_build(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                     FlatTexture *volume, GpError *error);

#endif
