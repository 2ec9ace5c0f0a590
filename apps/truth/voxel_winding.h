/* How often a closed surface goes round the centres of voxels: winding numbers, in double.
 *
 * The winding number of a point is 1 inside of a surface whose triangles turn counter-clockwise
 * seen from outside, 2 where two such parts overlap, 0 outside and in a hollow, whose wall is
 * turned the other way; inside out it is negative. It is well defined where as many triangles run
 * along each edge one way as the other; else it depends on the axis, as parity does.
 */
#ifndef APPS_TRUTH_VOXEL_WINDING_H
#define APPS_TRUTH_VOXEL_WINDING_H

#include "apps/truth/voxel_truth.h"

typedef struct VoxelWinding {
    uint8_t *odd; /* voxels that an odd number of triangles lies above, as bits of voxel_truth.h */
    uint8_t *inside;      /* those of a winding number other than 0 */
    uint64_t odd_columns; /* that cross an odd number of triangles, above, in or below the volume */
    uint64_t doubled;     /* voxels whose winding number is even and not 0: inside, but not odd */
} VoxelWinding;

/* Counts what lines along an axis, one through each voxel's centre, cross above it: 1 where a
 * triangle's outside faces up, -1 where it faces down.
 * in     triangles: in voxels
 * errors GP_ERROR_MEMORY; owns: the caller, until voxel_winding_free
 * note   Lines are moved aside by less than 2^-29 voxel, all the same way and so that no centre
 *        lies on a plane of them: what lies exactly on the surface is then inside or outside alike
 *        along all three axes. Of two triangles that share an edge a line crosses one, as in
 *        voxel_solid, and what rounding decides is nearer to the surface than 2^-29.
 * source ours; signed crossings are the degree of a map, counted at a regular value */
GpResult voxel_winding_make(const TruthTriangle *triangles, uint32_t count, uint32_t size, int axis,
                            VoxelWinding *winding);
void voxel_winding_free(VoxelWinding *winding); /* zeroes it; a zeroed one is fine */

#endif
