/* Convex pieces: their near and their far sides in two targets, and both put under what is in front of them.
 * source paper 002, sections 4.1 and 4.2 */
#ifndef SHADERS_FRAGMENTS_CONVEX_H
#define SHADERS_FRAGMENTS_CONVEX_H

#include "shaders_c/fragments/fragment.h"

/* Fragments of triangles that are seen counter-clockwise go to target 0, others to target 1; the other
 * target gets 0. To be drawn by MAX onto 0: light, and 1 more than what is let through. */
extern const GpProgram convex_program, convex_glass_program;

/* Over cells of pixels, GP_POSITION, 3: slots 0 and 1, in place, the first before the second: light, and what
 * is let through. */
extern const GpProgram convex_join_program;

/* A fragment as it is, likewise. */
extern const GpProgram convex_knot_program, convex_knot_glass_program;

#endif
