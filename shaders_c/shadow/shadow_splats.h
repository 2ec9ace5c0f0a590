/* Splats that receive shadows: the surface that their sums make, lit under one map.
 *
 * Slots 0 and 3 hold the sums, slot 2 what hides, as splat_over has 0, 1 and 2; slot 1 is the map.
 * Drawn twice: over the picture, with how much of a pixel the surface covers as alpha; and, solid,
 * where that is half at least, with depth and the visibility of the light as alpha.
 */
#ifndef SHADERS_SHADOW_SPLATS_H
#define SHADERS_SHADOW_SPLATS_H

#include "shaders_c/points/normalize.h"
#include "shaders_c/shadow/shadow.h"

typedef struct ShadowSplatsUniforms {
    NormalizeUniforms normalize; /* its light counts for nothing */
    ShadowUniforms shadow;       /* its diffuse colour is white, ambient the scene's light */
    /* the map is asked so far towards the light: discs stand out of the surface that their mean is,
     * by less than their radius */
    float lift;
    float solid; /* above 0: of the second draw */
} ShadowSplatsUniforms;

extern const GpProgram shadow_splats_hardware_program, shadow_splats_plain_nearest_program,
    shadow_splats_plain_bilinear_program;

#endif
