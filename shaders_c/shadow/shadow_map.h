/* The first pass of shadow mapping in its plain form: depth as a colour. The hardware form draws
 * depth_only. */
#ifndef SHADERS_SHADOW_MAP_H
#define SHADERS_SHADOW_MAP_H

#include "pipeline/shader/program.h"

typedef struct ShadowMapUniforms {
    float mvp[4][4]; /* world to the light's clip space */
} ShadowMapUniforms;

extern const GpProgram shadow_map_program;

#endif
