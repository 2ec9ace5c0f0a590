/* Voxelization as a technique: what may be set, what is swept, what is true. */
#ifndef APPS_TECHNIQUES_VOXEL_TECHNIQUE_H
#define APPS_TECHNIQUES_VOXEL_TECHNIQUE_H

#include "apps/techniques/technique.h"
#include "apps/techniques/voxel/inputs/scene.h"

/* Its scenes begin with a VoxelScene; a placement is to be set before the first frame is built. */
extern const Technique voxel_technique;

/* The same for solids, so that their chart is one of its own: what is right in one is wrong in the
 * other. */
extern const Technique solid_technique;

/* What the technique leaves in work->made, beside the flat texture in work->color. */
typedef struct VoxelMade {
    VoxelSetting setting;
    VoxelBox box;
    FlatTexture sheet;
} VoxelMade;

#endif
