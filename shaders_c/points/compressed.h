/* What the vertex shaders of compressed surfels need of each patch. */
#ifndef SHADERS_POINTS_COMPRESSED_H
#define SHADERS_POINTS_COMPRESSED_H

/* Part of a program's uniforms: 16 floats. */
typedef struct CompressedFrame {
    float origin[3];   /* the place whose codes are 0 */
    float steps[3][3]; /* by code: place = origin + x steps[0] + y steps[1] + z steps[2] */
    float radius[2];   /* radius = 2^(radius[0] + code * radius[1]); not in the printed form */
    /* share = share[0] + code * share[1], 0 to 1: the root of how much of the area 2 pi radius^2 a
     * surfel stands for */
    float share[2];
} CompressedFrame;

enum { COMPRESSED_RADII = 256 }; /* of the printed form, in a texture of that width and one row */

#endif
