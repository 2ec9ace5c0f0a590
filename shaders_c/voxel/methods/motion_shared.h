/* Vertices into voxels. For shader files only. */
#ifndef SHADERS_VOXEL_METHODS_MOTION_SHARED_H
#define SHADERS_VOXEL_METHODS_MOTION_SHARED_H

#include <glasspipe/shader.h>
#include "shaders_c/voxel/methods/motion.h"

GP_INLINE float3 into_voxels(const VoxelMotion *motion, float3 position)
{
    float3 q = m4x3(position, motion->to_voxels);
    if (motion->twist != 0.0f) {
        float2 turn = sincos_((q.y - motion->centre) * motion->twist);
        flt x = q.x - motion->centre, z = q.z - motion->centre;
        q.x = turn.x * x + turn.y * z + motion->centre;
        q.z = turn.x * z - turn.y * x + motion->centre;
    }
    return q;
}

#endif
