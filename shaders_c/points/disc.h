/* Points without filters: one pixel, a square, or a round disc, each hiding what is behind it. The
 * rivals of splats, and QSplat's way of drawing. Uniforms are those of splats. */
#ifndef SHADERS_POINTS_DISC_H
#define SHADERS_POINTS_DISC_H

#include "shaders_c/points/splat.h"

/* Points one pixel wide; squares, and discs facing the eye, as wide as their surfels'
 * projections. */
extern const GpProgram point_pixel_program, point_square_program, point_round_program;

/* The same, lit at each point: light is towards the light, world, unit length. */
typedef struct LitPointUniforms {
    SplatUniforms splat;
    float light[3];
    float ambient;
} LitPointUniforms;

extern const GpProgram lit_pixel_program, lit_square_program, lit_round_program;

#endif
