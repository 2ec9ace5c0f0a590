/* One model in a volume, or two: where each of them lies, and what becomes of the voxels they
 * share. */
#ifndef APPS_TECHNIQUES_VOXEL_INPUTS_PAIR_H
#define APPS_TECHNIQUES_VOXEL_INPUTS_PAIR_H

#include "apps/techniques/voxel/volume/combine.h"
#include "apps/techniques/voxel/inputs/scene.h"

/* How a model is put beside, or into, something else. */
typedef struct VoxelPlace {
    double fit;     /* its longest side in those of the other, with the same centre; 0: as it is */
    double move[3]; /* after that, in longest sides of the other */
} VoxelPlace;

typedef struct VoxelPair {
    const VoxelScene *scenes[2]; /* the second NULL: none */
    const char *names[2];        /* for messages */
    VoxelPlace place;            /* of the second; without one, of the first in its volume */
    VoxelCombine combine;
} VoxelPair;

typedef struct VoxelPairMade {
    FlatTexture volumes[2]; /* of each model */
    FlatTexture result;     /* of both; of one model its own */
    VoxelRange range;       /* what the result may lie in */
    VoxelRange around;      /* what the models may lie in */
    VoxelBox boxes[2];      /* of each model; the volume's place in their spaces */
} VoxelPairMade;

/* Where the volume of one model lies in its space. */
VoxelBox voxel_pair_box(const VoxelPair *pair, uint32_t size);

/* Makes flat textures and appends the passes of models and of what becomes of them. Two models lie
 * in the box of both, unless the first is placed.
 * errors those of voxel_scene_draw; GP_ERROR_INVALID: voxels of so many bits cannot be combined so
 *        */
GpResult voxel_pair_build(const VoxelPair *pair, const VoxelSetting *setting, Frame *frame,
                          VoxelPairMade *made, GpError *error);

#endif
