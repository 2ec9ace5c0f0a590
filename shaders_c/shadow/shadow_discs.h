/* The discs of splats in a light's map: quads of two triangles, with what lies outside the disc
 * left out. So any view of a light will do, warped ones too, and depths are biased by their slope
 * as ever. */
#ifndef SHADERS_SHADOW_DISCS_H
#define SHADERS_SHADOW_DISCS_H

#include "pipeline/shader/program.h"

typedef struct ShadowDiscUniforms {
    float mvp[4][4]; /* world to clip */
} ShadowDiscUniforms;

/* GP_TEXCOORD0: (0, 0) in the disc's middle, of length 1 at its rim. Depth alone; and depths in a
 * colour target, as shadow_map has them. */
extern const GpProgram shadow_disc_program, shadow_disc_map_program;

#endif
