/* Small copies of one mesh, each at its own place. */
#ifndef SHADERS_PLACED_H
#define SHADERS_PLACED_H

#include "pipeline/shader/program.h"

typedef struct PlacedUniforms {
    float mvp[4][4]; /* world to clip */
    float place[4];  /* world: x, y, z of the model's origin, and its scale */
    float light[3];  /* towards the light, world, unit length */
    float albedo[3]; /* linear colour */
    float ambient;
} PlacedUniforms;

extern const GpProgram placed_program;

#endif
