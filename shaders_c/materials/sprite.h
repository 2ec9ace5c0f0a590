/* Points as shaded balls, perspective cameras without shear only. */
#ifndef SHADERS_SPRITE_H
#define SHADERS_SPRITE_H

#include "pipeline/shader/program.h"

typedef struct SpriteUniforms {
    float mvp[4][4]; /* world to clip */
    float light[3];  /* towards the light, world, unit length */
    float ambient;   /* light on the dark side, 1 is full */
    float height;    /* of the viewport, pixels */
} SpriteUniforms;

extern const GpProgram sprite_program;

#endif
