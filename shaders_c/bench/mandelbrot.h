/* One long loop, on quads in clip space: the Mandelbrot set. */
#ifndef SHADERS_MANDELBROT_H
#define SHADERS_MANDELBROT_H

#include "pipeline/shader/program.h"

/* z = z^2 + c, at most 64 times; how often is the brightness. Without uniforms. */
extern const GpProgram mandelbrot_program;

#endif
