/* Signs as bits. For shader files only. */
#ifndef SHADERS_VOXEL_INPUTS_IMPLICIT_SHARED_H
#define SHADERS_VOXEL_INPUTS_IMPLICIT_SHARED_H

#include "shaders_c/common/cover_shared.h"

typedef struct TwoTargets {
    float4 any, all;
} TwoTargets;

/* Samples are taken four at a time: one instruction for all of them. */
enum { FOURS = 8 };

/* A texel's word of what is below its bound, sample by sample. */
GP_INLINE float4 signs_below(const float4 value[FOURS], const float bound[4 * FOURS])
{
    flt byte[4];
    for (int i = 0; i < 4; i++) {
        float4 low = slt(value[2 * i], u4(bound + 8 * i));
        float4 high = slt(value[2 * i + 1], u4(bound + 8 * i + 4));
        byte[i] = mad(dp4(high, vec4(1, 2, 4, 8)), 16, dp4(low, vec4(1, 2, 4, 8)));
    }
    return mul(vec4(byte[2], byte[1], byte[0], byte[3]), 1.0f / 255);
}

#endif
