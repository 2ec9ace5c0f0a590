/* Arithmetic alone, on quads in clip space: chains of multiply-adds. */
#ifndef SHADERS_ARITHMETIC_H
#define SHADERS_ARITHMETIC_H

#include "pipeline/shader/program.h"

typedef struct ArithmeticUniforms {
    float factor[4], addend[4]; /* of the chains */
} ArithmeticUniforms;

/* Four chains of 64 steps v = v * factor + addend, as a loop and written out. */
extern const GpProgram mad_loop_program;
extern const GpProgram mad_flat_program;

#endif
