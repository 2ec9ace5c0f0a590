/* The printed solid: rows scanned along three axes, and the majority of what they say. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_SOLID_ROWS_H
#define APPS_TECHNIQUES_VOXEL_METHODS_SOLID_ROWS_H

#include "apps/techniques/voxel/methods/directions.h"

/* The inside of a model along each axis, and the majority of the three: a voxel is in the solid
 * where two scans say so.
 * in/out crossings: where lines along each axis cross the surface (VOXEL_ALONG_ALL); are
 *        overwritten
 * out    solid: merged; the scan along z where setting->axes is 1
 * returns the solids of the three scans, all in the volume's places
 * source Dong et al., Pacific Graphics 2004, solid voxelization. The print leaves open how the
 *        three are merged, and what rows are scanned against. On the synthesized surface they would
 *        meet voxels beside which it passes, in runs of any length; what lines along a row's own
 *        axis cross it meets once each. */
VoxelDirections voxel_row_scan(const VoxelSetting *setting, Frame *frame,
                               const VoxelDirections *crossings, const FlatTexture *solid);

#endif
