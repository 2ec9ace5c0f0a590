/* One colour. */
#ifndef SHADERS_UNLIT_H
#define SHADERS_UNLIT_H

#include "pipeline/shader/program.h"

typedef struct UnlitUniforms {
    float mvp[4][4]; /* world to clip */
    float color[4];  /* linear, alpha not premultiplied */
} UnlitUniforms;

extern const GpProgram unlit_program;

#endif
