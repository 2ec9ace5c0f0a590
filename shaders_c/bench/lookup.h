/* Textures that decide: one gives the place in another, or whether a pixel is there at all. Quads
 * in clip space, without uniforms. */
#ifndef SHADERS_LOOKUP_H
#define SHADERS_LOOKUP_H

#include "pipeline/shader/program.h"

/* Red and green of slot 0 are the place in slot 1, whose level 0 is shown. */
extern const GpProgram lookup_program;

/* Slot 0 where its alpha is at least one half. */
extern const GpProgram cut_out_program;

#endif
