/* Depth peeling of one layer a pass, and of two.
 * source Everitt, "Interactive order-independent transparency", NVIDIA 2001; Bavoil and Myers,
 *        "Order independent transparency with dual depth peeling", NVIDIA 2008 */
#ifndef SHADERS_FRAGMENTS_PEEL_H
#define SHADERS_FRAGMENTS_PEEL_H

#include "shaders_c/fragments/fragment.h"

/* The nearest fragment, and the nearest behind the depths in slot 0: to be drawn with a depth test
 * and write. The depth that is written is the shader's own, so that it compares with what was
 * stored bit for bit. */
extern const GpProgram fragment_first_program, fragment_first_glass_program;
extern const GpProgram fragment_next_program, fragment_next_glass_program;

/* Dual: targets 0 and 1, R32F, become -depth of the nearest and depth of the farthest fragment by
 * MAX; the second program takes those between them, slots 0 and 1, and writes the fragments at them
 * to targets 2 and 3. Cleared to DUAL_NONE, which is less than any fragment. */
#define DUAL_NONE (-65504.0f)
extern const GpProgram dual_first_program, dual_first_glass_program;
extern const GpProgram dual_next_program, dual_next_glass_program;

/* Over all pixels: slots 0 and 1, in place, to targets 0 and 1; nothing where there is none. */
extern const GpProgram dual_layers_program;

#endif
