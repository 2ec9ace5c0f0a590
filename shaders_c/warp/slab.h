/* Rays through the box of a depth image: uniforms that all programs that walk along them have. */
#ifndef SHADERS_WARP_SLAB_H
#define SHADERS_WARP_SLAB_H

#include "shaders_c/warp/light.h"

typedef struct SlabUniforms {
    float first[2], side[2]; /* of the box on the picture, which goes from 0 to 1 */
    float depth
        [4]; /* at the share r of a ray's way: (depth[0] + depth[1] r) / (depth[2] + depth[3] r) */
    WarpLightUniforms light; /* of lit programs */
} SlabUniforms;

#endif
