/* An even ground, y = 0, that things stand on: a texture under a light from without end, and its
 * shadows. */
#ifndef SHADERS_WARP_GROUND_H
#define SHADERS_WARP_GROUND_H

#include "pipeline/shader/program.h"

typedef struct GroundUniforms {
    float mvp[4][4];
    float repeats;               /* of the texture, over a unit of length */
    float map[3][3];             /* of x, z and 1: u, v and depth in the shadow map */
    float ambient[3], direct[3]; /* light that is everywhere, and that the map lets through */
} GroundUniforms;

/* GP_POSITION: x and z in the world. Slot 0: colours; slot 1, of the shadowed program: the map, a
 * depth surface that compares. */
extern const GpProgram ground_program, ground_shadowed_program;

#endif
