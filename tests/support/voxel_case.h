/* Volumes drawn for tests: models in memory, on one device or on all that must agree. */
#ifndef TESTS_VOXEL_CASE_H
#define TESTS_VOXEL_CASE_H

#include "apps/base/voxel_range.h"
#include "apps/techniques/voxel/inputs/scene.h"
#include "apps/truth/voxel_truth.h"

/* --- models ----------------------------------------------------------------------------------- */

/* Triangles in their volume; freed by voxel_case_free. */
typedef struct VoxelCase {
    VoxelScene scene; /* the mesh, all of whose arrays are there */
    VoxelModel model; /* refers to it; colours are places in the volume, 0 to 1 along x, y, z */
    TruthTriangle *triangles; /* [model.triangle_count], in voxels */
    uint32_t size;
} VoxelCase;

/* A built-in shape or, where the name has a dot, a mesh file; skips the test where there is no such
 * file. It fills its volume.
 * in   turn: about an axis askew to x, y and z, by an angle whose half has this tangent; 0: none */
VoxelCase voxel_case_open(const char *name, double turn, uint32_t size);

/* Triangles without common corners, in voxels; without normals.
 * in   corners: [9 * triangle_count], x, y, z of each */
VoxelCase voxel_case_of(const float *corners, uint32_t triangle_count, uint32_t size);

void voxel_case_free(VoxelCase *c);

/* --- volumes ---------------------------------------------------------------------------------- */

/* Appends the passes of a volume to a frame in which there is room. */
typedef void VoxelDraw(const void *context, Frame *frame, const FlatTexture *flat);

/* Draws a volume of one bit a voxel; fails the running test where the list does not run, or sets
 * bits beyond the volume's end.
 * in   everywhere: on every device (devices.h); else on one
 * out  bits: [voxel_bytes(size)] */
void voxel_run(VoxelDraw *draw, const void *context, uint32_t size, bool everywhere, uint8_t *bits);

/* The volume of a setting of 1, 8 or 16 bits; otherwise as voxel_run.
 * out  voxels: in order, as flat_texture_read gives them */
void voxel_case_draw(const VoxelCase *c, const VoxelSetting *setting, bool everywhere,
                     uint8_t *voxels);

/* The same on one device, into memory that the caller frees with gp_free. */
uint8_t *voxel_case_volume(const VoxelCase *c, const VoxelSetting *setting);

/* The voxels of a flat texture; the caller frees them with gp_free. */
uint8_t *voxel_read(const FlatTexture *flat);

/* --- voxels ----------------------------------------------------------------------------------- */

/* Whether a voxel is set. */
bool voxel_at(const uint8_t *bits, uint32_t size, uint32_t x, uint32_t y, uint32_t z);

/* Voxels of a flat texture of one bit that lie in a range. */
uint64_t voxel_count_range(const FlatTexture *flat, const VoxelRange *range);

/* Voxels in a that are not in b. */
uint64_t voxel_count_without(const uint8_t *a, const uint8_t *b, uint32_t size);

#endif
