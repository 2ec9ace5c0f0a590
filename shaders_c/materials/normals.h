/* The world-space normal as a colour. */
#ifndef SHADERS_NORMALS_H
#define SHADERS_NORMALS_H

#include "pipeline/shader/program.h"

typedef struct NormalsUniforms {
    float mvp[4][4]; /* world to clip */
} NormalsUniforms;

extern const GpProgram normals_program;

#endif
