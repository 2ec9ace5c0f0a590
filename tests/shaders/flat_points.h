/* Points whose values are the same on all their pixels, as many as a program may have. */
#ifndef TESTS_SHADERS_FLAT_POINTS_H
#define TESTS_SHADERS_FLAT_POINTS_H

#include "pipeline/shader/program.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Width and height of the targets, in pixels. */
typedef struct FlatPointsUniforms {
    float size[2];
} FlatPointsUniforms;

/* Inputs of all: GP_POSITION 3 (x and y in pixels), GP_COLOR 4, GP_POINT_SIZE 1. Discard: some of
 * the pixels, and all of some points. */
extern const GpProgram flat_points, flat_points_discard, flat_points_targets4;

#ifdef __cplusplus
}
#endif

#endif
