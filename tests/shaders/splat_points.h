/* Points with a place in the sprite, in perspective, which discard what lies outside a disc. */
#ifndef TESTS_SHADERS_SPLAT_POINTS_H
#define TESTS_SHADERS_SPLAT_POINTS_H

#include "pipeline/shader/program.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Width and height of the targets, in pixels. */
typedef struct SplatPointsUniforms {
    float size[2];
} SplatPointsUniforms;

/* Inputs of all: GP_POSITION 4 (x and y in pixels, depth, w), GP_COLOR 4, GP_POINT_SIZE 1. Plain: a
 * colour and nothing else, of points of one pixel. */
extern const GpProgram splat_points, splat_points_targets2, splat_points_plain;

#ifdef __cplusplus
}
#endif

#endif
