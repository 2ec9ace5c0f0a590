/* An even ground that things stand on: a texture under a light from without end, and the shadows of it. */
#ifndef SHADERS_WARP_GROUND_H
#define SHADERS_WARP_GROUND_H

#include "pipeline/shader/program.h"

typedef struct GroundUniforms {
    float mvp[4][4];
    float map[4][4];             /* to the shadow map: u w, v w, depth w, w */
    float ambient[3], direct[3]; /* light that is everywhere, and that the map lets through */
} GroundUniforms;

/* GP_POSITION, world; GP_TEXCOORD0. Slot 0: colours; slot 1, of the shadowed program: the map, a depth
 * surface that compares. */
extern const GpProgram ground_program, ground_shadowed_program;

#endif
