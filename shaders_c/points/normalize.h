/* The last pass of splatting: sums of weighted attributes become a picture. To be drawn over the
 * whole target; slot 0 holds colour x weight and weight, slot 1 normal x weight and distance x
 * weight; beside their edges is nothing (GP_BORDER). What stands at the pixel itself is read in
 * place: the same sums, and the depth of what hides, 1 where nothing does.
 *
 * Alpha is how much of a pixel the surface covers; the picture lies over the background by it.
 */
#ifndef SHADERS_POINTS_NORMALIZE_H
#define SHADERS_POINTS_NORMALIZE_H

#include "pipeline/shader/program.h"

enum { HIDES_SLOT = 2, SUMS_HERE_SLOT = 4, SURFACE_HERE_SLOT = 5 };

typedef struct NormalizeUniforms {
    float coverage[2];   /* alpha = weight * coverage[0] + coverage[1], clamped to 0..1 */
    float background[4]; /* multiplied by its alpha */
    float texel[2];      /* 1 / width, 1 / height of the picture */

    /* of the program that shades */
    float axes[3][3]; /* of the eye, world: right, down, forward */
    float per_focal;  /* 1 / focal */
    float centre[2];  /* of the viewport, pixels from its top left */
    float light[3];   /* towards it, world, unit length */
    float ambient, specular, shininess;
    float depth[2]; /* depth of a distance z: depth[0] + depth[1] / z */
} NormalizeUniforms;

/* Colour alone. */
extern const GpProgram splat_normalize_program;

/* Lit once a pixel (Blinn and Phong), with the surface's depth where it covers half of a pixel. */
extern const GpProgram splat_shade_program;

#endif
