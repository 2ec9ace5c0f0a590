/* Transparent layers by depth peeling, and how they are put together. */
#ifndef SHADERS_PEELING_H
#define SHADERS_PEELING_H

#include "pipeline/shader/program.h"

typedef struct PeelUniforms {
    float mvp[4][4];   /* model to clip */
    float model[4][4]; /* model to world; normals need it without unequal scaling */
    float light[3];    /* towards the light, world, unit length */
    float color[4];    /* linear colour of either side, alpha */
} PeelUniforms;

/* The nearest layer, and the nearest behind the depths in slot 0 (read by gp_load_local). */
extern const GpProgram peel_first_program;
extern const GpProgram peel_next_program;

/* Quads in clip space that read slot 0 at the pixel's own position. */
typedef struct LayerUniforms {
    float background[3];
} LayerUniforms;

extern const GpProgram layer_premultiply_program; /* colour times alpha */
extern const GpProgram layer_background_program;  /* over a background, which ends opaque */

#endif
