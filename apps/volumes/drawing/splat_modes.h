/* How voxels come to the pipeline: the five modes of paper 003 (4.1.2, table 4). */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_MODES_H
#define APPS_VOLUMES_DRAWING_SPLAT_MODES_H

#include "apps/volumes/drawing/splat_sheets.h"

/* What a mode needs beside the voxels. A zeroed one is of no mode. */
typedef struct VoxelFeed {
    Sheets *sheets;
    const struct VoxelFlatUniforms *flat; /* of flat kernels */
    GpSurface *values;                    /* of VT and PT: the flat texture */
    uint32_t columns;
    const uint8_t *corners; /* of QD: of as many voxels as the longest run has */
    const uint32_t *indices;
} VoxelFeed;

/* in     sheets: of the frame, before its first pass
 * errors GP_ERROR_UNSUPPORTED: too large a volume for a texture, or for a draw a voxel */
GpResult voxel_feed_begin(Sheets *sheets, VoxelFeed *feed, GpError *error);

/* Draws a run of a slice to the present sheet, with a filter: EWA, reconstruction or low-pass. */
void voxel_feed_run(const VoxelFeed *feed, uint32_t slice, const VoxelRun *run, VoxelFilter filter);

#endif
