/* The ways of drawing a volume, as a table. */
#ifndef APPS_TECHNIQUES_VOLUME_METHODS_H
#define APPS_TECHNIQUES_VOLUME_METHODS_H

#include "apps/techniques/volume/model.h"

typedef struct VolumeMethodRow {
    /* Draws over the target; makes first, once, what it keeps of the model.
     * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED with the reason */
    GpResult (*add)(VolumeModel *model, const VolumeOptions *options, const VolumeTarget *target,
                    Frame *frame, GpError *error);
    /* Takes another transfer function, the model's. errors GP_ERROR_MEMORY */
    GpResult (*classify)(VolumeModel *model, GpError *error);
    /* Bytes that are kept to draw the volume, for each sample; of splats for each that is one. */
    double (*bytes_per_voxel)(const VolumeModel *model, const VolumeOptions *options);
    /* Splats of a frame. NULL: it has none */
    uint64_t (*splats)(const VolumeModel *model);
    /* Whether it is judged by the kernels of classified samples; else by the data. NULL: never */
    bool (*has_kernels)(const VolumeOptions *options);
    void (*close)(VolumeModel *model); /* where nothing was made too */
} VolumeMethodRow;

extern const VolumeMethodRow volume_methods[VOLUME_METHODS];

#endif
