/* Splats over a picture that has been drawn, and that has a depth buffer.
 *
 * What is there hides splats far behind it: its depth, pushed back as splats push theirs, is where
 * their visibility begins. Splats a little behind it are added up all the same, so that a surface
 * is whole where it passes through another; which of the two is seen, the depth test says pixel by
 * pixel.
 */
#ifndef SHADERS_POINTS_OVER_H
#define SHADERS_POINTS_OVER_H

#include "shaders_c/points/normalize.h"

typedef struct BehindUniforms {
    float depth[2];  /* depth of a distance z: depth[0] + depth[1] / z */
    float behind[2]; /* of a distance z: behind[0] + behind[1] z */
} BehindUniforms;

/* The depth of slot 0, pushed back; white, where splats that hide are black. */
extern const GpProgram splat_behind_program;

typedef struct OverUniforms {
    NormalizeUniforms normalize; /* background and ambient count for nothing */
    float ambient[3];            /* light that comes from everywhere */
} OverUniforms;

/* The surface, lit as phong lights it; slots as splat_shade has them, but slot 2 is 1 where no
 * splat hides anything. Multiplied by its alpha, with its depth; discarded where there is none. */
extern const GpProgram splat_over_program;

#endif
