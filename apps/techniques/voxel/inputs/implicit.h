/* Volumes of implicit surfaces: solids and surfaces of functions, of one bit a voxel. */
#ifndef APPS_TECHNIQUES_VOXEL_INPUTS_IMPLICIT_H
#define APPS_TECHNIQUES_VOXEL_INPUTS_IMPLICIT_H

#include "apps/base/polynomial.h"
#include "apps/techniques/voxel/methods/voxelize.h"

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
 * in     box: from the function's space to voxels
 * errors GP_ERROR_INVALID: a callback's samples do not fit a texture
 * note   the callback is called here, once for each centre or corner, x fastest */
GpResult voxel_implicit(const VoxelFunction *function, const VoxelBox *box, VoxelKind kind,
                        Frame *frame, const FlatTexture *flat, GpError *error);

#endif
