/* Draws that come again: passes of a group that draw the same primitives as an earlier one, as
 * peeling and bucket sorting do, with other pixel shaders, states and targets. Their vertices are
 * shaded and binned once; and where their fragments are found by primitives alone, a tile finds
 * them once (lanes/shade/repeated.h). */
#ifndef GP_FAST_REPEAT_H
#define GP_FAST_REPEAT_H

#include "pipeline/fast/draws/group.h"

/* The first pass of the group that has the primitives of this one, draw by draw, as far as lists
 * tell: one of the latest few, or what that one repeats; NULL: none. */
const FastPass *fast_find_repeated(const FastGroup *group, const GpPass *pass, int lanes);

/* Whether a draw, prepared but for its vertices, may have those of the first. */
bool fast_has_vertices_of(const FastDraw *draw, const FastDraw *first);

/* Of all passes of a group, gives a number to draws whose fragments are worth keeping. */
void fast_number_repeated(FastGroup *group);

#endif
