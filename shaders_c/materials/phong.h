/* Blinn-Phong lighting per pixel, one directional light. */
#ifndef SHADERS_PHONG_H
#define SHADERS_PHONG_H

#include "pipeline/shader/program.h"

typedef struct PhongUniforms {
    float mvp[4][4];  /* world to clip */
    float eye[3];     /* world */
    float light[3];   /* towards the light, world, unit length */
    float ambient[3]; /* linear colour */
    float diffuse[3];
    float specular;
    float shininess; /* exponent */
} PhongUniforms;

extern const GpProgram phong_program;

#endif
