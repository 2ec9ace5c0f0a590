/* Surfaces for deferred lighting, in three float targets: 0 albedo, alpha 1 where a surface is;
 * 1 world normal, unit length, w = 0; 2 world position, w = 1. */
#ifndef SHADERS_GBUFFER_H
#define SHADERS_GBUFFER_H

#include "pipeline/shader/program.h"

typedef struct GbufferUniforms {
    float mvp[4][4];  /* world to clip */
    float diffuse[3]; /* albedo, linear colour */
} GbufferUniforms;

extern const GpProgram gbuffer_program;

#endif
