/* A model's levels as others walk them: QSplat's recursion, and sequential point trees.
 *
 * Both stop at the nodes whose discs, as wide as all that is below them, are seen at most `detail`
 * pixels wide, and at the leaves. The one goes down patch by patch on the processor; the other has
 * all nodes in one array by falling size of their parents, of which a prefix holds all that is
 * wanted.
 * source Rusinkiewicz and Levoy, "QSplat", SIGGRAPH 2000; Dachsbacher, Vogelgsang and Stamminger,
 *        "Sequential point trees", SIGGRAPH 2003
 */
#ifndef APPS_POINTS_HIERARCHY_H
#define APPS_POINTS_HIERARCHY_H

#include "apps/points/cull.h"

/* What a walk found. Zeroed is empty. */
typedef struct HierarchyCut {
    Surfel *surfels; /* [count], copies, patch after patch */
    uint32_t count;
} HierarchyCut;

/* Walks down from the coarsest level of each patch that may be seen.
 * in     detail: pixels, > 0; keeps_back: patches that face away are not left out
 * out    cut: its memory is the caller's, gp_free(cut->surfels)
 * errors GP_ERROR_MEMORY */
GpResult hierarchy_walk(const Patches *patches, const PointView *view, double detail,
                        bool keeps_back, HierarchyCut *cut);

/* A node of a sequence: drawn where its own size is small enough, and its parent's is not. */
typedef struct SequenceNode {
    Surfel surfel;
    float size[2]; /* radii: its own, 0 of leaves; its parent's, without end of roots */
} SequenceNode;

typedef struct Sequence {
    SequenceNode *nodes; /* by falling radius of the parent */
    uint32_t count;
} Sequence;

/* in     patches: with surfels
 * out    sequence: free with sequence_free
 * errors GP_ERROR_MEMORY */
GpResult sequence_build(const Patches *patches, Sequence *sequence);

void sequence_free(Sequence *sequence); /* zeroes; a zeroed one is fine */

/* How many nodes, from the first, may be wanted.
 * in   nearest: depth of the nearest surfel, > 0; per_radius: depth at which a radius of 1 is seen
 *      as wide as the detail asks */
uint32_t sequence_prefix(const Sequence *sequence, double nearest, double per_radius);

#endif
