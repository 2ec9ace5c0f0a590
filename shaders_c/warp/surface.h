/* Depth images as surfaces in the world, under the depth test: colours, and normals, of their textures. */
#ifndef SHADERS_WARP_SURFACE_H
#define SHADERS_WARP_SURFACE_H

#include "shaders_c/warp/light.h"

typedef struct SurfaceUniforms {
    float mvp[4][4];
    WarpLightUniforms light; /* of the lit programs */
    float map[4][4]; /* to the light's shadow map: u w, v w, depth w, w. Of the shadowed program */
} SurfaceUniforms;

/* GP_POSITION is a place, GP_TEXCOORD0 its place on the textures. Slot 0 has colours; alpha is 1. */
extern const GpProgram surface_program;

/* Lit at each pixel; slot 1 has normals, a component n as (n + 1) / 2. */
extern const GpProgram surface_lit_program;

/* The same where slot 2, a depth surface that compares, lets the light through. */
extern const GpProgram surface_shadowed_program;

#endif
