/* Planar depth images warped straight to the view: the way of a point inside the image's plane, and
 * that of the plane to the view, are one matrix (source: ours, after paper 001, section 2). */
#ifndef SHADERS_WARP_DIRECT_H
#define SHADERS_WARP_DIRECT_H

#include "shaders_c/warp/detail.h"
#include "shaders_c/warp/light.h"

/* Places of the image are (s x, s y, depth, 1): x and y in its pixels, s = spread[0] depth +
 * spread[1] is the depth where rays meet in an eye, and 1 where they are parallel. */
typedef struct DirectUniforms {
    float to_clip[4][4], to_world[3][4]; /* of places */
    float spread[2];
    WarpDetailUniforms detail; /* of the programs with detail */
    WarpLightUniforms light;   /* of the lit ones */
} DirectUniforms;

/* Vertices: GP_POSITION x, y, depth; GP_TEXCOORD0 where the colour is. Slot 0: colours; slot 1 of
 * lit ones: normals, (n + 1) / 2. */
extern const GpProgram direct_program, direct_lit_program;
extern const GpProgram direct_detail_program, direct_detail_lit_program;

#endif
