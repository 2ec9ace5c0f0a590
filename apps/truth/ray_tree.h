/* A tree of boxes over triangles, so that a ray looks at few of them. */
#ifndef APPS_TRUTH_RAY_TREE_H
#define APPS_TRUTH_RAY_TREE_H

#include "apps/base/bounds.h"
#include "apps/truth/ray_triangle.h"
#include "pipeline/base/base.h"

enum {
    TRUTH_LEAF_SIZE = 4,
    TRUTH_TREE_DEPTH = 64 /* no leaf lies deeper below the root */
};

typedef struct TruthNode {
    Bounds box;
    /* a leaf's first place in the order; else the child on the low side, the other is the next
     * one */
    uint32_t first;
    uint32_t count; /* of a leaf's triangles; 0: two children */
    uint32_t axis;  /* that parts the children */
} TruthNode;

/* Builds the tree; node 0 is the root.
 * in     count: at least 1
 * out    order: [count] the triangle at each place; nodes: [2 * count - 1], not all of them used
 * errors GP_ERROR_MEMORY
 * source Wald, "On fast construction of SAH-based bounding volume hierarchies", RT 2007: the cut
 *        between bins of centres that makes the least sum of area times triangles */
GpResult truth_tree_build(const TruthTriangle *triangles, uint32_t count, uint32_t *order,
                          TruthNode *nodes);

#endif
