/* A texture with Blinn-Phong lighting per pixel, one directional light. */
#ifndef SHADERS_TEXTURED_PHONG_H
#define SHADERS_TEXTURED_PHONG_H

#include "pipeline/shader/program.h"

typedef struct TexturedPhongUniforms {
    float mvp[4][4];  /* world to clip */
    float eye[3];     /* world */
    float light[3];   /* towards the light, world, unit length */
    float ambient[3]; /* linear colour; this and diffuse are multiplied by the texel */
    float diffuse[3];
    float specular;
    float shininess; /* exponent */
} TexturedPhongUniforms;

extern const GpProgram textured_phong_program;

#endif
