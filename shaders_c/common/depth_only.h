/* Depth and no colour: for shadow maps and early depth. */
#ifndef SHADERS_DEPTH_ONLY_H
#define SHADERS_DEPTH_ONLY_H

#include "pipeline/shader/program.h"

typedef struct DepthOnlyUniforms {
    float mvp[4][4]; /* world to clip */
} DepthOnlyUniforms;

extern const GpProgram depth_only_program;

#endif
