/* Lists of fragments: every fragment of a pixel in a surface of its own, in the order of their
 * drawing, and the nearest of them, put together.
 *
 * An entry is a texel of A32B32G32R32F: depth; red and green, multiplied by what the fragment
 * hides, 12 bits each; blue, likewise, and above it the fragment's place; what it lets through. By
 * depth, and then by the third channel, entries are in order.
 */
#ifndef SHADERS_FRAGMENTS_LISTS_H
#define SHADERS_FRAGMENTS_LISTS_H

#include "shaders_c/fragments/fragment.h"

/* Depths of what is no fragment; those are 0 to 1. */
#define LIST_BEFORE -1.0f /* before all */
#define LIST_LOST   1.5f  /* written over while it was in flight */
#define LIST_NONE   2.0f  /* after all, and after the last of its list */

/* The fragment as an entry. */
extern const GpProgram list_program;

/* The same in 32 bits: depth in 16, colour in 5, 6 and 5. One alpha for all.
 * source the multi-depth test: Liu, Huang, Liu and Wu, "FreePipe: a programmable parallel rendering
 *        architecture for efficient multi-fragment effects", I3D 2010 */
extern const GpProgram list_packed_program;

/* The same with a window, GP_TEXCOORD0, 1, of the triangle as its first corner has it. Target 1,
 * R32F: the window of the pixel's last fragment, of which slot 0 has the one before; target 2: that
 * one's entry, which is lost where both are of one window: to be drawn by MAX, depth alone. */
extern const GpProgram list_window_program;

enum { LIST_KEPT = 4, LIST_AT_ONCE = 11 };

/* Over all pixels, GP_POSITION, 3: puts entries in order. Slots 0 to 3: the nearest so far, in
 * order; 4: an entry, none up to which counts; 5 to 15: entries. Targets 0 to 3: the nearest
 * now. */
extern const GpProgram list_nearest_program;

/* Over all pixels: slots 0 to 3 put together, front to back; the first `count` of them: light, and
 * what is let through. */
typedef struct ListLayersUniforms {
    float count;
} ListLayersUniforms;

extern const GpProgram list_layers_program;

#endif
