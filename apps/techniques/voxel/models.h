/* The models of a voxelization, and the frames that are made of them. */
#ifndef APPS_TECHNIQUES_VOXEL_MODELS_H
#define APPS_TECHNIQUES_VOXEL_MODELS_H

#include "apps/techniques/technique.h"
#include "apps/techniques/voxel/options.h"
#include "apps/techniques/voxel/truths.h"

/* The scene of the technique. */
typedef struct VoxelModels {
    VoxelScene scene, second; /* scene first: tests place it */
    GpVolume scan;
    VoxelTruths truths; /* of the first alone */
    VoxelPair pair;     /* refers to both */
    char names[2][256];
} VoxelModels;

/* What the technique leaves in frame->made. */
typedef struct VoxelMade {
    VoxelSetting setting;
    VoxelPairMade pair;
} VoxelMade;

/* As a technique's functions. */
GpResult voxel_models_open(const TechniqueInput *input, void **scene, GpError *error);
void voxel_models_close(void *scene);
GpResult voxel_models_build(void *scene, const void *setting, GpDevice *device, Frame *frame,
                            GpError *error);
void voxel_models_resolve(const void *scene, void *setting);
GpResult voxel_models_volume(const Frame *frame, GpVolume *volume, GpError *error);
GpResult voxel_models_show(void *scene, const void *setting, Frame *frame, GpError *error);

#endif
