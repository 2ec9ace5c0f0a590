/* A texture over the whole target; without uniforms. */
#ifndef SHADERS_BLIT_H
#define SHADERS_BLIT_H

#include "pipeline/shader/program.h"

extern const GpProgram blit_program;

#endif
