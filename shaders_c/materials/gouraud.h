/* Blinn-Phong lighting per vertex, one directional light. */
#ifndef SHADERS_GOURAUD_H
#define SHADERS_GOURAUD_H

#include "pipeline/shader/program.h"

typedef struct GouraudUniforms {
    float mvp[4][4];  /* world to clip */
    float eye[3];     /* world */
    float light[3];   /* towards the light, world, unit length */
    float ambient[3]; /* linear colour */
    float diffuse[3]; /* linear colour */
    float specular;
    float shininess; /* exponent */
} GouraudUniforms;

extern const GpProgram gouraud_program;

#endif
