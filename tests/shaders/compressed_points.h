/* What the vertex shader makes of compressed surfels: one pixel each, of two targets of four
 * floats. */
#ifndef TESTS_SHADERS_COMPRESSED_POINTS_H
#define TESTS_SHADERS_COMPRESSED_POINTS_H

#include "pipeline/shader/program.h"
#include "shaders_c/points/compressed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct CompressedPointsUniforms {
    CompressedFrame frame;
} CompressedPointsUniforms;

/* Inputs: GP_POSITION 2 the pixel's middle in clip space, GP_TEXCOORD0 4 the words, or the printed
 * form's first stream and GP_TEXCOORD1 4 its second. Target 0: position and radius; target 1:
 * normal and share; target 2: tangent and corner, printed form only. Vertex texture 0: the printed
 * form's radii. */
extern const GpProgram compressed_points, compressed_points_printed;

#ifdef __cplusplus
}
#endif

#endif
