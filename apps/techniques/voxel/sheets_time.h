/* The printed method of voxelization by its steps, as its tables tell them. */
#ifndef APPS_TECHNIQUES_VOXEL_SHEETS_TIME_H
#define APPS_TECHNIQUES_VOXEL_SHEETS_TIME_H

#include "apps/techniques/timed_setting.h"
#include "apps/techniques/voxel/inputs/scene.h"

/* Milliseconds, medians, of the steps. */
typedef struct SheetsTimes {
    double raster;     /* triangles into slabs, along three axes */
    double texelize;   /* slabs into flat textures */
    double synthesize; /* flat textures along x and y turned and merged into the one along z */
} SheetsTimes;

/* Measures the passes of --method sheets in groups, each by the clock's plan.
 * in     frame: one that has been drawn
 * errors those of gp_device_run, GP_ERROR_MEMORY */
GpResult sheets_time_steps(const TechniqueClock *clock, const Frame *frame, SheetsTimes *steps,
                           GpError *error);

/* Milliseconds, the median, of sorting a model's triangles as --method sheets does once for a model
 * that stands still, and before every frame for one that moves. errors GP_ERROR_MEMORY */
GpResult sheets_time_sort(const TechniqueClock *clock, const VoxelScene *scene, uint32_t size,
                          double *ms, GpError *error);

/* Bytes of all surfaces that a list draws into. */
size_t sheets_bytes(const GpList *list);

#endif
