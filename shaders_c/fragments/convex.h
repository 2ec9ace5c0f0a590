/* Convex pieces: their near and their far sides in two targets, and both put under what is in front
 * of them.
 * source paper 002, sections 4.1 and 4.2 */
#ifndef SHADERS_FRAGMENTS_CONVEX_H
#define SHADERS_FRAGMENTS_CONVEX_H

#include "shaders_c/fragments/fragment.h"

/* Fragments of triangles that are seen counter-clockwise go to target 0, others to target 1; the
 * other target gets 0. To be drawn by MAX onto 0: light, and 1 more than what is let through. */
extern const GpProgram convex_program, convex_glass_program;

/* Over cells of pixels, GP_POSITION, 3: slots 0 and 1, in place, the first before the second:
 * light, and what is let through. */
extern const GpProgram convex_join_program;

/* A fragment as it is, likewise; knots are sorted by the machine. */
extern const GpProgram convex_knot_program, convex_knot_glass_program;

/* Of faces in a slab the fragment of a pixel that the stencil lets through: target 0 as it is,
 * target 1, R32F, its depth. */
extern const GpProgram convex_slab_program, convex_slab_glass_program;

enum { SLAB_LAYERS = 4 };

#define SLAB_NONE 2.0f /* depth of what is no fragment */

/* Over cells of pixels: slots 0 to 3, in place, such fragments, 4 to 7 their depths: put in order,
 * and together. */
extern const GpProgram convex_slab_join_program;

#endif
