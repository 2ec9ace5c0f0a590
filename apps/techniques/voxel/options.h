/* What may be set of a voxelization: how it is done, of what, and how it is looked at. */
#ifndef APPS_TECHNIQUES_VOXEL_OPTIONS_H
#define APPS_TECHNIQUES_VOXEL_OPTIONS_H

#include "apps/techniques/settings.h"
#include "apps/techniques/voxel/pictures/picture.h"

/* The setting of the technique; what follows `voxels` is aside of the key. */
typedef struct VoxelOptions {
    VoxelSetting voxels;

    double box[4]; /* scale, offset; scale 0: the model's own box */
    bool takes_points;
    double twist;            /* degrees */
    const char *with, *scan; /* NULL: none */
    VoxelCombine combine;
    VoxelPlace place;

    bool wants_report;
    VoxelPicture picture;
} VoxelOptions;

extern const SettingField voxel_settings[];
extern const VoxelOptions voxel_option_defaults;

/* As a technique's check. */
GpResult voxel_options_check(const void *options, uint32_t given, const char *extension,
                             GpError *error);

#endif
