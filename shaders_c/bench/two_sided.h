/* Blinn-Phong lighting of both sides of a surface, per pixel, without and with a shadow map. */
#ifndef SHADERS_TWO_SIDED_H
#define SHADERS_TWO_SIDED_H

#include "pipeline/shader/program.h"

typedef struct TwoSidedUniforms {
    float mvp[4][4];        /* model to clip */
    float model[4][4];      /* model to world, without scaling */
    float light_clip[4][4]; /* world to the clip space of the shadow map */
    float eye[3];           /* world */
    float light[3];         /* towards the light, world, unit length */
    float albedo[3];        /* linear colour */
    float ambient;
    float specular;
    float shininess; /* exponent */
    float bias;      /* of the shadow, in depth units */
    float map_size;  /* texels a side of the shadow map */
} TwoSidedUniforms;

/* Without a shadow. */
extern const GpProgram two_sided_program;

/* The three ways to ask a shadow map in slot 0: a depth surface behind a sampler that compares
 * (LESS_EQUAL, which may filter), one read as depths and compared once, and four of its depths
 * compared and blended by hand. The latter two want a sampler that picks one texel and clamps. */
extern const GpProgram two_sided_compare_program;
extern const GpProgram two_sided_nearest_program;
extern const GpProgram two_sided_pcf_program;

#endif
