/* Volumes of what is no mesh: functions, parametric surfaces and points. Each appends passes that
 * draw into a flat texture of one bit a voxel.
 */
#ifndef APPS_TECHNIQUES_VOXEL_INPUTS_IMPLICIT_H
#define APPS_TECHNIQUES_VOXEL_INPUTS_IMPLICIT_H

#include "apps/base/polynomial.h"
#include "apps/techniques/voxel/methods/voxelize.h"

/* --- implicit surfaces ------------------------------------------------------------------------ */

/* What is inside where it is below 0. */
typedef struct VoxelFunction {
    Polynomial polynomial; /* evaluated by the pixel shader, in binary32; or: */
    double (*evaluate)(void *user, const double place[3]); /* not NULL: by the processor */
    void *user;
} VoxelFunction;

/* A polynomial by its name, "quartic", or its text.
 * errors those of polynomial_parse */
GpResult voxel_function_parse(const char *text, VoxelFunction *function, GpError *error);

/* The cube from -reach to reach, as a volume. The quartic reaches to 2.27. */
VoxelBox voxel_box_of_cube(double reach, uint32_t size);
#define VOXEL_FUNCTION_REACH 3.0

/* Solid: voxels whose centres are inside. Surface: voxels of whose eight corners some are inside
 * and some are not; a surface that comes and goes between corners is not seen.
 * in     box: from the function's space to voxels; kind: VoxelKind
 * errors GP_ERROR_INVALID: a callback's samples do not fit a texture
 * note   the callback is called here, once for each centre or corner, x fastest */
GpResult voxel_implicit(const VoxelFunction *function, const VoxelBox *box, int kind, Frame *frame,
                        const FlatTexture *flat, GpError *error);

/* --- parametric surfaces ---------------------------------------------------------------------- */

/* Names of what voxel_parametric knows, NULL at the end: sphere, torus, moebius, klein, teapot. */
extern const char *const voxel_parametric_names[];

/* Points closer than this, in voxels, along both parameters leave no hole: each point of the
 * surface has one within a half of the diagonal, 0.36 voxels, so that of two voxels with a common
 * face the line between whose centres meets the surface, one is set. */
#define VOXEL_PARAMETRIC_STEP 0.5

/* The surface's own box as a volume. errors GP_ERROR_INVALID: no such surface */
GpResult voxel_parametric_box(const char *name, uint32_t size, VoxelBox *box, GpError *error);

/* The surface of a name by a grid of points, placed by the vertex shader.
 * in     step: at most so far apart, in voxels; the number of points follows from bounds of the
 *        surface's derivatives
 * errors GP_ERROR_INVALID: no such surface; more points than VOXEL_PARAMETRIC_MAX_POINTS */
enum { VOXEL_PARAMETRIC_MAX_POINTS = 1 << 26 };
GpResult voxel_parametric(const char *name, double step, const VoxelBox *box, Frame *frame,
                          const FlatTexture *flat, GpError *error);

/* --- points ----------------------------------------------------------------------------------- */

/* The voxel of each point; points outside the volume are left out.
 * in     positions: [3 * count], borrowed
 * errors GP_ERROR_INVALID: no points */
GpResult voxel_points(const float *positions, uint32_t count, const VoxelBox *box, Frame *frame,
                      const FlatTexture *flat, GpError *error);

#endif
