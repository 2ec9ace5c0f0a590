/* Lighting of the surfaces that the gbuffer program left: four point lights over the whole target.
 */
#ifndef SHADERS_DEFERRED_H
#define SHADERS_DEFERRED_H

#include "pipeline/shader/program.h"

enum { DEFERRED_LIGHTS = 4 };

typedef struct DeferredUniforms {
    float ambient[3];    /* linear colour, multiplied by the albedo */
    float background[3]; /* linear colour where no surface is */
    struct {
        float position[3];          /* world */
        float color[3];             /* linear; 0 switches the light off */
        float inverse_square_range; /* 1 / range^2, world units: no light reaches farther */
    } lights[DEFERRED_LIGHTS];
} DeferredUniforms;

extern const GpProgram deferred_program;

#endif
