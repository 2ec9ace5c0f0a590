/* Volumes of parametric surfaces, and of points: of one bit a voxel. */
#ifndef APPS_TECHNIQUES_VOXEL_INPUTS_PARAMETRIC_H
#define APPS_TECHNIQUES_VOXEL_INPUTS_PARAMETRIC_H

#include "apps/techniques/voxel/methods/voxelize.h"

/* Triangles no farther than this from the surface, in voxels, and voxels held against them with a
 * margin of 1/128 (VOXEL_PARAMETRIC_MARGIN), which leaves room for the rounding of positions: every
 * voxel that the surface touches is set, and none that is 1/64 from it. */
#define VOXEL_PARAMETRIC_CHORD (1.0 / 160)

/* The box of a surface (sphere, torus, moebius, klein, teapot) as a volume.
 * errors GP_ERROR_INVALID: no such surface */
GpResult voxel_parametric_box(const char *name, uint32_t size, VoxelBox *box, GpError *error);

/* The surface of a name by the triangles of a grid, placed by the vertex shader.
 * in     chord: in voxels, how far the surface may be from them; how fine the grid is follows from
 *        bounds of the surface's derivatives
 * errors GP_ERROR_INVALID: no such surface; more triangles than VOXEL_PARAMETRIC_MOST
 * source the bound is that of linear interpolation: of a surface S over a triangle with legs h
 *        along u and k along v, (h h |Suu| + 2 h k |Suv| + k k |Svv|) / 8. The mean of S at the
 *        corners, with a point's shares, differs from S there by half the mean of the second
 *        derivatives along the ways to the corners, and the mean square of such a way along u is at
 *        most h h / 4 */
enum { VOXEL_PARAMETRIC_MOST = 1 << 26 };
GpResult voxel_parametric(const char *name, double chord, const VoxelBox *box, Frame *frame,
                          const FlatTexture *flat, GpError *error);

/* The voxel of each point; points outside the volume are left out.
 * in     positions: [3 * count], borrowed
 * errors GP_ERROR_INVALID: no points */
GpResult voxel_points(const float *positions, uint32_t count, const VoxelBox *box, Frame *frame,
                      const FlatTexture *flat, GpError *error);

#endif
