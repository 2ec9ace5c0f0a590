/* A volume that has been opened, how it is seen, and what its methods have made of it. */
#ifndef APPS_TECHNIQUES_VOLUME_MODEL_H
#define APPS_TECHNIQUES_VOLUME_MODEL_H

#include "apps/techniques/technique.h"
#include "apps/techniques/volume/options.h"
#include "apps/techniques/volume/truths.h"
#include "apps/volumes/drawing/splat.h"

typedef struct VolumeModel {
    Field field;
    Transfer transfer;
    VolumeView view;
    RaycastVolume rays; /* empty until a setting needs it; so are all below */
    SlicesVolume slices;
    VolumeSplats splats;
    VolumePicture data;   /* what the picture should be */
    VolumePicture method; /* what splats should make it, with kernels as these */
    VolumeKernel kernel;
} VolumeModel;

/* As a technique's open; and its close, for what no method has made. */
GpResult volume_model_open(const TechniqueInput *input, void **model, GpError *error);
void volume_model_close(void *model);

/* The truths, each found once. errors GP_ERROR_MEMORY */
GpResult volume_model_data(VolumeModel *model, int threads, GpError *error);
GpResult volume_model_method(VolumeModel *model, const VolumeOptions *options, int threads,
                             GpError *error);

#endif
