/* Depth images as surfaces in the world, under the depth test: colours, and normals, of their
 * textures. */
#ifndef SHADERS_WARP_SURFACE_H
#define SHADERS_WARP_SURFACE_H

#include "shaders_c/warp/light.h"

typedef struct SurfaceUniforms {
    float mvp[4][4];
    WarpLightUniforms light; /* of the lit programs */
    float map[3][4];         /* to the light's shadow map: u, v, depth. Of the shadowed program */
} SurfaceUniforms;

/* Ways are the same all over the surface: unit vectors in the world. */
typedef struct SurfaceDistantUniforms {
    float mvp[4][4], map[3][4];
    float source[3], half_way[3]; /* towards the light; between it and the eye */
    float color[3], ambient[3];
    float specular, shininess;
} SurfaceDistantUniforms;

/* GP_POSITION is a place, GP_TEXCOORD0 its place on the textures. Slot 0 has colours; alpha is
 * 1. */
extern const GpProgram surface_program;

/* Lit at each pixel; slot 1 has normals, a component n as (n + 1) / 2. */
extern const GpProgram surface_lit_program;

/* The same where slot 2, a depth surface that compares, lets the light through, which comes from
 * without end. */
extern const GpProgram surface_shadowed_program;

/* Those two for surfaces that are small in the picture: they take SurfaceDistantUniforms, and light
 * only outsides. */
extern const GpProgram surface_distant_program, surface_distant_shadowed_program;

#endif
