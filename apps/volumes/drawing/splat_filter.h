/* Which filter the voxels of a patch need. */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_FILTER_H
#define APPS_VOLUMES_DRAWING_SPLAT_FILTER_H

#include "apps/volumes/drawing/splat_eye.h"
#include "apps/volumes/voxels.h"

/* VOXEL_EWA, VOXEL_RECONSTRUCTION or VOXEL_LOW_PASS: what the setting says, and where it leaves the
 * choice, by the four corners of the patch. A patch that reaches in front of the near plane has
 * both filters, but for parallel rays.
 * source paper 003, (8) and 4.1.1: reconstruction alone where all corners have u2 < (rk / rh) cmin,
 *        the low-pass filter alone where all have u2 > (rk / rh) cmax, with cmin = 0.3 and cmax = 2
 *        (1 + 2 tan(fov / 2))^2; rk and rh are where kernel and filter are cut, rh in the plane at
 *        distance 1; VOXEL_BOUNDED: ours (apps/base/filter_bound.h) */
VoxelFilter splat_filter_of_patch(const VoxelEye *eye, const VoxelOrder *order, const Field *field,
                                  const VolumeSplatSetting *setting, uint32_t slice,
                                  uint32_t patch);

/* The same of voxels at depths between two: slabs have no corners. */
VoxelFilter splat_filter_of_depths(const VoxelEye *eye, const VolumeSplatSetting *setting,
                                   double nearest, double farthest);

/* What sums are kept in: the setting, or, where it leaves the choice, halves where the eye is
 * farther from the volume's box than (rk / rh) 0.3 cmax, and bytes where it is not.
 * source paper 003, 4.1.5. DEVIATES: the ratio is printed upside down */
VoxelSums splat_sums(const VoxelEye *eye, const Field *field, const VolumeSplatSetting *setting);

#endif
