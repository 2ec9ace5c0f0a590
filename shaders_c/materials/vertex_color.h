/* The colours of the vertices, interpolated in perspective. */
#ifndef SHADERS_VERTEX_COLOR_H
#define SHADERS_VERTEX_COLOR_H

#include "pipeline/shader/program.h"

typedef struct VertexColorUniforms {
    float mvp[4][4]; /* world to clip */
} VertexColorUniforms;

extern const GpProgram vertex_color_program;

#endif
