/* Models in volumes by the printed method, for tests: a shape with its triangles in voxel space, and
 * the volume that a setting makes of it. */
#ifndef TESTS_SHEETS_CASE_H
#define TESTS_SHEETS_CASE_H

#include "apps/shapes.h"
#include "apps/tech_voxel_sheets.h"
#include "tests/truth/voxel_truth.h"

/* Owned by the caller until sheets_case_free. */
typedef struct SheetsCase {
    VoxelModel model;
    TruthTriangle *triangles; /* of model.triangle_count, in voxels */
    uint32_t size;
    float *positions, *normals, *colors; /* of the model */
    uint32_t *indices;
} SheetsCase;

/* A built-in shape that fills a volume; turned first about an axis askew to all, by an angle whose half
 * has the tangent `turn`. Colours are its place in the volume, 0 to 1 along x, y, z. */
SheetsCase sheets_case_shape(const char *name, uint32_t size, double turn);

/* A mesh of the data folder that fills a volume; skips the test where it is not there. */
SheetsCase sheets_case_mesh(const char *name, uint32_t size);

/* Triangles in a volume: corners are in voxels. */
SheetsCase sheets_case_triangles(const TruthTriangle *triangles, uint32_t count, uint32_t size);

void sheets_case_free(SheetsCase *given);

/* A setting's work and its volume; the caller frees the work. Fails the test on an error. */
Worksheet sheets_case_build(const SheetsCase *given, const VoxelSetting *setting, Work *work);

/* Runs a work on a device like this. */
void sheets_case_run(const Work *work, const GpDeviceDesc *device);

/* Voxels of a worksheet; the caller frees them with gp_free. */
uint8_t *sheets_case_read(const Worksheet *sheet);

/* All of it: builds, runs, reads. */
uint8_t *sheets_case_volume(const SheetsCase *given, const VoxelSetting *setting);

/* Voxels of one bit that a has and b has not. */
uint64_t sheets_case_beyond(const uint8_t *a, const uint8_t *b, uint32_t size);

#endif
