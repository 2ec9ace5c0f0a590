/* A texture with Lambert lighting per pixel, one directional light. */
#ifndef SHADERS_TEXTURED_H
#define SHADERS_TEXTURED_H

#include "pipeline/shader/program.h"

typedef struct TexturedUniforms {
    float mvp[4][4];  /* world to clip */
    float light[3];   /* towards the light, world, unit length */
    float ambient[3]; /* linear colour; both are multiplied by the texel */
    float diffuse[3];
} TexturedUniforms;

extern const GpProgram textured_program;

#endif
