/* A texture over the whole target. */
#ifndef SHADERS_BLIT_H
#define SHADERS_BLIT_H

#include "pipeline/shader/program.h"

typedef struct BlitUniforms {
} BlitUniforms; /* none: a draw's uniforms may be NULL */

extern const GpProgram blit_program;

#endif
