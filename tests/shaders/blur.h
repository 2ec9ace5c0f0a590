/* The mean of a texel and its two neighbours along one direction, for a technique of the tests. */
#ifndef TESTS_SHADERS_BLUR_H
#define TESTS_SHADERS_BLUR_H

#include "pipeline/shader/program.h"

typedef struct BlurUniforms {
    float step[2]; /* to the next texel, in texture coordinates */
} BlurUniforms;

extern const GpProgram blur_program; /* texture 0; positions are in clip space already */

#endif
