/* Nodes of a sequential point tree as opaque squares: of all that are sent, those are drawn that
 * are small enough where they are, and whose parents are not.
 * source Dachsbacher, Vogelgsang and Stamminger, "Sequential point trees", SIGGRAPH 2003
 * DEVIATES: by depth instead of distance, as splats are projected; a parent's depth is not known,
 *        but it is at most its radius from its child's
 */
#ifndef SHADERS_POINTS_SEQUENCE_H
#define SHADERS_POINTS_SEQUENCE_H

#include "shaders_c/points/disc.h"

typedef struct SequenceUniforms {
    LitPointUniforms lit; /* unlit: ambient 1 */
    float per_radius;     /* depth at which a radius of 1 is small enough */
} SequenceUniforms;

/* Points; texture coordinate 0 is a node's own radius, 0 of a leaf, and its parent's. */
extern const GpProgram sequence_square_program;

#endif
