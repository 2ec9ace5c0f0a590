/* How much of a model's volume a volume of voxels has wrong: by points of which it is known whether
 * they are inside, each held against the voxel that it lies in. One number for volumes of all
 * sizes.
 */
#ifndef APPS_TRUTH_VOXEL_PROBES_H
#define APPS_TRUTH_VOXEL_PROBES_H

#include "apps/truth/voxel_truth.h"
#include "pipeline/base/pool.h"

/* Points spread evenly over a cube around a model, an eighth wider than its box is long, which is
 * all of a volume of 23 voxels a side or more; in its own space. */
typedef struct VoxelProbes {
    double low[3], side;
    uint8_t *inside; /* a bit for each */
    uint64_t inside_count;
} VoxelProbes;

/* What is inside: what has an odd number of triangles above it; or a winding number other than 0
 * (voxel_winding.h). */
typedef enum VoxelInside { VOXEL_BY_PARITY, VOXEL_BY_WINDING } VoxelInside;

/* Counts triangles along z, edges told as by voxel_solid.
 * in     count: at least 1
 * errors GP_ERROR_MEMORY; owns: the caller, until voxel_probes_free */
GpResult voxel_probes_make(const TruthTriangle *triangles, uint32_t count, VoxelInside inside,
                           VoxelProbes *probes);
void voxel_probes_free(VoxelProbes *probes); /* zeroes it; a zeroed one is fine */

/* Points on the wrong side, as a share of those inside (of one where none is): 1 where nothing is
 * set, more where much is set that is outside. Points outside the volume are not asked for.
 * in   space: from the model's space to that of the volume
 * note The probes' number leaves a few in a hundred of it uncertain where a hundredth is wrong of a
 *      slender model: volumes of one size and its double are well apart. */
double voxel_probes_wrong(const VoxelProbes *probes, const VoxelBox *space, const uint8_t *bits,
                          GpPool *pool);

#endif
