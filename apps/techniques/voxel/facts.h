/* What is reported of a voxelized model: whether it is closed, and what its insides are along each
 * axis. */
#ifndef APPS_TECHNIQUES_VOXEL_FACTS_H
#define APPS_TECHNIQUES_VOXEL_FACTS_H

#include "apps/base/text.h"
#include "apps/scene/mesh_report.h"
#include "apps/techniques/voxel/inputs/scene.h"

#include <jansson.h>

typedef struct VoxelFacts {
    MeshReport mesh;
    bool has_solids;         /* what follows is known */
    uint64_t odd_columns[3]; /* along x, y, z: columns that an odd number of triangles crosses */
    uint64_t disagreements;  /* voxels that are inside along one axis and outside along another */
} VoxelFacts;

/* Facts of the mesh alone. errors GP_ERROR_MEMORY */
GpResult voxel_facts_find(const VoxelScene *scene, VoxelFacts *facts, GpError *error);

/* Adds those of its solids: makes one along each axis, by the method xor, of the mesh in its own
 * box. Voxels that disagree where no column is odd have their centres on the surface, or nearly.
 * errors those of voxel_build and gp_device_run, GP_ERROR_MEMORY */
GpResult voxel_facts_find_solids(const VoxelScene *scene, uint32_t size, GpDevice *device,
                                 VoxelFacts *facts, GpError *error);

/* Adds them as lines of a table. */
void voxel_facts_add(const VoxelFacts *facts, Text *lines);

/* The caller owns it. */
json_t *voxel_facts_json(const VoxelFacts *facts);

/* --- what solids are asked -------------------------------------------------------------------- */

/* Columns that an odd number of triangles crosses.
 * in   parity: one bit a column, x + size * y, which is 1 there. A solid that was made by turning
 *      over what lies below each triangle has it in its lowest layer, its first size * size
 *      bits. */
uint64_t voxel_odd_columns(const uint8_t *parity, uint32_t size);

/* Voxels that are not the same in three solids of one model, each made along another axis.
 * in   solids: [3][(size^3 + 7) / 8], bit x + size * (y + size * z) */
uint64_t voxel_disagreements(const uint8_t *const solids[3], uint32_t size);

#endif
