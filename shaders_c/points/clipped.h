/* Surfels on a crease as splats that end at clip lines through their centres: splat.h's programs.
 *
 * A line of the surfel's plane and the eye span a plane, which is a line on the picture, wherever
 * the perspective: pixels count by how much of them lies inwards of it, as if it were square to the
 * way there, so that the sides of a crease share what is on it.
 * source Zwicker et al., "Perspective accurate splatting", GI 2004, 4.3. DEVIATES: lines are a
 *        pixel wide there
 */
#ifndef SHADERS_POINTS_CLIPPED_H
#define SHADERS_POINTS_CLIPPED_H

#include "shaders_c/points/splat.h"

/* Inputs beside a surfel's: in texture coordinates 0 and 1 two directions inwards, in the surfel's
 * plane; w of the first is 1 where both bound it, -1 where either does, of the second the factor of
 * its alpha (apps/points/surfels.h: SurfelClip). Uniforms: SplatUniforms. */
extern const GpProgram clipped_visibility_program;
extern const GpProgram clipped_color_program;
extern const GpProgram clipped_surface_program;

#endif
