/* The distance along the view as a grey, perspective cameras only. */
#ifndef SHADERS_DEPTH_H
#define SHADERS_DEPTH_H

#include "pipeline/shader/program.h"

typedef struct DepthUniforms {
    float mvp[4][4]; /* world to clip */
    float near;      /* world units along the view: black here */
    float far;       /* and white here; beyond near */
} DepthUniforms;

extern const GpProgram depth_program;

#endif
