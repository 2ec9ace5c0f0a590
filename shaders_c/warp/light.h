/* A light on what depth images show: uniforms that all programs of theirs that light have. */
#ifndef SHADERS_WARP_LIGHT_H
#define SHADERS_WARP_LIGHT_H

#include "pipeline/shader/program.h"

/* Places have a fourth component of 1; directions, of parallel views and of light from without end,
 * 0. */
typedef struct WarpLightUniforms {
    float eye[4];    /* world; a direction points towards the eye */
    float source[4]; /* of the light, world; a direction points towards it */
    float color[3], ambient[3];
    float specular, shininess;
} WarpLightUniforms;

#endif
