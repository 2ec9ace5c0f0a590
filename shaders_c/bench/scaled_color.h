/* Coloured triangles in clip space, times a number. */
#ifndef SHADERS_SCALED_COLOR_H
#define SHADERS_SCALED_COLOR_H

#include "pipeline/shader/program.h"

typedef struct ScaledColorUniforms {
    float scale;
} ScaledColorUniforms;

extern const GpProgram scaled_color_program;

#endif
