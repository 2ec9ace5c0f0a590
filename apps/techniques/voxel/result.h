/* What a voxelization gave: taken from its flat textures, written to a file, and told. */
#ifndef APPS_TECHNIQUES_VOXEL_RESULT_H
#define APPS_TECHNIQUES_VOXEL_RESULT_H

#include "apps/frame/run_statistics.h"
#include "apps/techniques/voxel/facts.h"
#include "apps/techniques/voxel/inputs/pair.h"
#include "pipeline/io/volume/volume_file.h"

#include <jansson.h>

/* Zeroed until it is taken; owns its volume until gp_volume_free. */
typedef struct VoxelResult {
    const GpSurface *picture; /* NULL: the result is a volume */
    GpVolume volume;
    uint64_t hash;      /* of the picture, or of the volume's voxels in order */
    uint64_t voxels;    /* that are not 0 */
    uint64_t triangles; /* of meshes */
    bool is_touching;   /* the voxels are those that two models have */
    VoxelRange where;   /* the voxels, tightly; empty where there is none */
    bool has_facts;
    VoxelFacts facts;
} VoxelResult;

/* Takes a volume, and its voxels' number and range. A picture's hash is taken instead of the volume's
 * where there is a picture.
 * errors GP_ERROR_MEMORY */
GpResult voxel_result_take(const VoxelPairMade *made, const GpSurface *picture, bool is_touching,
                           VoxelResult *result);

/* Writes the picture, or the volume, by its name's end. errors those of picture_write_surface and
 * gp_volume_write */
GpResult voxel_result_write(const VoxelResult *result, const char *path, GpError *error);

/* Lines on stdout: the hash, the voxels, and the facts where there are any. */
void voxel_result_print(const VoxelResult *result);

/* Members beside the frame's, for --json. color: of the frame. The caller owns it. */
json_t *voxel_result_json(const VoxelResult *result, const RunStatistics *statistics,
                          const GpSurface *color);

#endif
