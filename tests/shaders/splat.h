/* Splats as surfels are drawn: elliptical Gaussians that add a weighted colour and a weighted
 * normal to two targets of floats. */
#ifndef TESTS_SHADERS_SPLAT_H
#define TESTS_SHADERS_SPLAT_H

#include "pipeline/shader/program.h"

/* Width and height of the targets, in pixels. */
typedef struct SplatUniforms {
    float size[2];
} SplatUniforms;

/* Inputs of all: GP_POSITION 3 (x and y in pixels, depth), GP_COLOR 3, GP_NORMAL 3, GP_TEXCOORD0 3
 * (the ellipse a x^2 + b x y + c y^2 = 1, in pixels from the centre), GP_POINT_SIZE 1. Square:
 * nothing is discarded, so that depth comes early. Depth: only that the ellipse covers pixels. */
extern const GpProgram splat, splat_square, splat_depth;

#endif
