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
    /* voxels inside of parts that overlap or are nested, so that their winding number is even, and
     * parity leaves them out */
    uint64_t doubled;
} VoxelFacts;

/* Facts of the mesh alone. errors GP_ERROR_MEMORY */
GpResult voxel_facts_find(const VoxelScene *scene, VoxelFacts *facts, GpError *error);

/* Adds those of its solids: the exact parity along each axis (voxel_winding.h) of the mesh in its
 * own box, whole and not twisted. The pipeline's own solids are the same but beside the surface,
 * where it snaps corners to 1/256 of a voxel: held against each other they would disagree there, of
 * any mesh.
 * errors GP_ERROR_MEMORY */
GpResult voxel_facts_find_solids(const VoxelScene *scene, uint32_t size, VoxelFacts *facts,
                                 GpError *error);

/* Voxels that parity leaves out, of a mesh that lies so in its volume; 0 where its edges are not
 * balanced, so that there is no winding number. errors GP_ERROR_MEMORY */
GpResult voxel_facts_count_doubled(const VoxelScene *scene, const MeshReport *mesh,
                                   const VoxelBox *box, uint64_t *doubled, GpError *error);

/* Adds them as lines of a table. */
void voxel_facts_add(const VoxelFacts *facts, Text *lines);

/* The caller owns it. */
json_t *voxel_facts_json(const VoxelFacts *facts);

#endif
