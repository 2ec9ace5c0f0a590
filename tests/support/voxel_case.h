/* Volumes drawn for tests: models in memory, on one device or on all that must agree. */
#ifndef TESTS_VOXEL_CASE_H
#define TESTS_VOXEL_CASE_H

#include "apps/tech_voxel.h"
#include "tests/truth/voxel_truth.h"

/* Appends the passes of a volume to a work in which there is room. */
typedef void VoxelDraw(const void *context, Work *work, const Worksheet *sheet);

/* Draws a volume of one bit a voxel; fails the running test where the list does not run, or sets bits beyond the
 * volume's end.
 * in   everywhere: on every executor, several threads and lane widths, which must give the same
 *      bits in all targets; else on the fast executor
 * out  bits: [voxel_bytes(size)] */
void voxel_draw(VoxelDraw *draw, const void *context, uint32_t size, bool everywhere,
                uint8_t *bits);

/* Triangles in their volume. Freed by voxel_case_free. */
typedef struct VoxelCase {
    float *positions;
    uint32_t *indices;
    uint32_t vertex_count, triangle_count, size;
    TruthTriangle *triangles; /* in voxels */
    VoxelModel model;         /* refers to the arrays */
} VoxelCase;

/* Takes a built-in shape or, where name has a dot, a mesh file; skips the test where there is no such
 * file. in  turn: row-major 3x3, before the fit into the box; NULL: none */
VoxelCase voxel_case_open(const char *name, const double turn[9], uint32_t size);

/* Of positions and indices, which it takes over from gp_alloc.
 * in   box: NULL: that of the triangles */
VoxelCase voxel_case_of(float *positions, uint32_t vertex_count, uint32_t *indices,
                        uint32_t triangle_count, uint32_t size, const VoxelBox *box);
void voxel_case_free(VoxelCase *c);

/* The volume of a setting of one bit a voxel; otherwise as voxel_draw. */
void voxel_case_draw(const VoxelCase *c, const VoxelSetting *setting, bool everywhere,
                     uint8_t *bits);

/* Voxels in a that are not in b. */
uint64_t voxel_count_without(const uint8_t *a, const uint8_t *b, uint32_t size);

#endif
