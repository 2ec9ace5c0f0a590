/* What is worth saying of a voxelization: how many voxels, where two models touch, whether a mesh
 * is closed. */
#ifndef APPS_TECHNIQUES_VOXEL_REPORT_H
#define APPS_TECHNIQUES_VOXEL_REPORT_H

#include "apps/techniques/technique.h"

/* As a technique's report. */
GpResult voxel_report(void *scene, const void *setting, const Frame *frame, GpDevice *device,
                      TechniqueReport *report, GpError *error);

#endif
