/* Depth images as cells between four pixels each, for rays that look for their surface. */
#ifndef SHADERS_WARP_CELLS_H
#define SHADERS_WARP_CELLS_H

#include "pipeline/shader/program.h"

/* Slot 0, points: the z of the four pixels round a corner between pixels: upper left and right,
 * lower left and right. */
typedef struct CellUniforms {
    float first[2], side[2]; /* of the box on slot 0, in texels */
    float texel[2];          /* 1 / width, 1 / height of slot 0 */
    float thickness;         /* of the surface, in z */
} CellUniforms;

#endif
