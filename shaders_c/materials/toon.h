/* Three bands of light and an inked rim. */
#ifndef SHADERS_TOON_H
#define SHADERS_TOON_H

#include "pipeline/shader/program.h"

typedef struct ToonUniforms {
    float mvp[4][4];  /* world to clip */
    float eye[3];     /* world */
    float light[3];   /* towards the light, world, unit length */
    float ambient[3]; /* linear colour: what the darkest band has */
    float diffuse[3]; /* linear colour: what the brightest band has on top */
    float bands[2];   /* cosines of the light's angle where the middle and bright bands begin */
    float outline;    /* cosine of the angle to the eye below which the rim is inked */
    float ink[3];     /* linear colour of the rim */
} ToonUniforms;

extern const GpProgram toon_program;

#endif
