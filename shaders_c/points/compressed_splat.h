/* The splats of splat.h, of compressed surfels: taken apart in the vertex shader, pass by pass; the
 * pixel shaders are the same. One draw a patch.
 *
 * Inputs: GP_TEXCOORD0 4 the words, of the printed form its first stream, and GP_TEXCOORD1 4 its
 * second (compressed_shared.h); of passes that have colours GP_COLOR 3, anything where there are
 * none. Vertex texture 0: the printed form's radii. */
#ifndef SHADERS_POINTS_COMPRESSED_SPLAT_H
#define SHADERS_POINTS_COMPRESSED_SPLAT_H

#include "shaders_c/points/compressed.h"
#include "shaders_c/points/splat.h"

typedef struct CompressedUniforms {
    SplatUniforms splat;
    CompressedFrame frame;
    float color[3]; /* of all surfels, and */
    float by_color; /* 0; where each has its own: 0, and 1 */
} CompressedUniforms;

extern const GpProgram compressed_visibility_program, compressed_color_program,
    compressed_surface_program;

extern const GpProgram printed_visibility_program, printed_color_program, printed_surface_program;

#endif
