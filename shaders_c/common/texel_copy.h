/* Texels of one surface into another of its size: the pixel shader brings them, the blend unit puts
 * them together with what is there. */
#ifndef SHADERS_TEXEL_COPY_H
#define SHADERS_TEXEL_COPY_H

#include "pipeline/shader/program.h"

/* To be drawn as triangles in clip space, GP_POSITION; without uniforms. Slot 0 is a surface of the
 * target's size, read in place. */
extern const GpProgram texel_copy_program;       /* its texels */
extern const GpProgram texel_complement_program; /* their bytes' complements: all bits inverted */
extern const GpProgram texel_depth_program;      /* white, at the depth that they are */

#endif
