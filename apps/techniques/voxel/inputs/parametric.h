/* Volumes of parametric surfaces, and of points: each point sets its voxel of one bit. */
#ifndef APPS_TECHNIQUES_VOXEL_INPUTS_PARAMETRIC_H
#define APPS_TECHNIQUES_VOXEL_INPUTS_PARAMETRIC_H

#include "apps/techniques/voxel/methods/voxelize.h"

/* Points closer than this, in voxels, along both parameters leave no hole: each point of the
 * surface has one within a half of the diagonal, 0.36 voxels, so that of two voxels with a common
 * face the line between whose centres meets the surface, one is set. */
#define VOXEL_PARAMETRIC_STEP 0.5

/* The box of a surface (sphere, torus, moebius, klein, teapot) as a volume.
 * errors GP_ERROR_INVALID: no such surface */
GpResult voxel_parametric_box(const char *name, uint32_t size, VoxelBox *box, GpError *error);

/* The surface of a name by a grid of points, placed by the vertex shader.
 * in     step: at most so far apart, in voxels; the number of points follows from bounds of the
 *        surface's derivatives
 * errors GP_ERROR_INVALID: no such surface; more points than VOXEL_PARAMETRIC_MAX_POINTS */
enum { VOXEL_PARAMETRIC_MAX_POINTS = 1 << 26 };
GpResult voxel_parametric(const char *name, double step, const VoxelBox *box, Frame *frame,
                          const FlatTexture *flat, GpError *error);

/* The voxel of each point; points outside the volume are left out.
 * in     positions: [3 * count], borrowed
 * errors GP_ERROR_INVALID: no points */
GpResult voxel_points(const float *positions, uint32_t count, const VoxelBox *box, Frame *frame,
                      const FlatTexture *flat, GpError *error);

#endif
