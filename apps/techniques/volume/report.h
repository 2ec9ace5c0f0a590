/* What there is to say of a picture of a volume. */
#ifndef APPS_TECHNIQUES_VOLUME_REPORT_H
#define APPS_TECHNIQUES_VOLUME_REPORT_H

#include "apps/techniques/volume/model.h"

/* As a technique's report. */
GpResult volume_report(void *model, const void *options, const Frame *frame, GpDevice *device,
                       TechniqueReport *report, GpError *error);

/* How far a picture is off: dB against what the data are, and against what its method stands for,
 * which is the same for all but splats of classified samples. */
typedef struct VolumeError {
    double psnr_data, psnr_method;
} VolumeError;

/* errors those of the truths */
GpResult volume_error(VolumeModel *model, const VolumeOptions *options, const GpSurface *picture,
                      int threads, VolumeError *off, GpError *error);

/* Samples, splats and bytes, for JSON. */
void volume_tell_size(const VolumeModel *model, const VolumeOptions *options, json_t *members);

#endif
