/* What is known of each visible surface, in four float targets: 0 world position, 1 normal, unit
 * length, 2 albedo, each with w = 1; 3 (depth, N.L, 0, 1). */
#ifndef SHADERS_SURFACE_MAPS_H
#define SHADERS_SURFACE_MAPS_H

#include "pipeline/shader/program.h"

typedef struct SurfaceMapsUniforms {
    float mvp[4][4]; /* world to clip */
    float light[3];  /* towards the light, world, unit length */
    float albedo[3]; /* linear colour */
} SurfaceMapsUniforms;

extern const GpProgram surface_maps_program;

#endif
