/* Oriented boxes over patches: a tree whose nodes are classified as wholes.
 *
 * source Chen et al., "A unified hardware-accelerated adaptive EWA splatting algorithm", Chinese
 *        Journal of Computers 2009, 4.2: the filter of the points of a box is decided where its
 *        corners agree, and in its halves where they do not; boxes after Gottschalk et al.,
 *        SIGGRAPH 1996
 */
#ifndef APPS_POINTS_BOXES_H
#define APPS_POINTS_BOXES_H

#include "apps/points/level.h"

/* Nodes in preorder: the first half of a node follows it, the second stands where the first
 * ends. */
typedef struct BoxNode {
    PatchBox box;                    /* holds the boxes of its patches */
    uint32_t first, count;           /* patches */
    uint32_t next;                   /* the node behind this one's subtree */
    float least_radius, most_radius; /* of the leaves of its patches */
} BoxNode;

typedef struct BoxTree {
    BoxNode *nodes; /* [node_count]: 2 patches - 1; nodes[0] holds all */
    uint32_t node_count;
} BoxTree;

/* errors GP_ERROR_MEMORY; owns: the caller, until box_tree_free */
GpResult box_tree_build(const Patches *patches, BoxTree *tree);

void box_tree_free(BoxTree *tree); /* zeroes; a zeroed one is fine */

/* Which class the points of a box are of: at least 0 where all are of one, else -1. */
typedef int (*BoxClassFn)(const void *user, const PointView *view, const BoxNode *node,
                          const BoxPlace *place);

/* Paper 003's (10) by the depths of the corners and by all radii, for surfels that face the eye
 * (cos theta = 1), distances
 * in radii that take rh pixels: 0 reconstruction, nearer than c_min; 1 low-pass, farther than
 *      c_max; 2 both.
 * in   user: DistanceRule */
typedef struct DistanceRule {
    double low_pass;  /* standard deviation of the filter, pixels */
    double near, far; /* c_min and c_max */
} DistanceRule;

int box_class_by_distance(const void *user, const PointView *view, const BoxNode *node,
                          const BoxPlace *place);

/* Classifies all patches but those whose boxes, as far down as they had to be asked, are outside of
 * the frustum.
 * in     undecided: the class of a patch of which no class can be said
 * out    class_of: [patch_count], -1 where a patch is outside
 * out    returns the number of nodes that were looked at */
uint32_t box_tree_classify(const BoxTree *tree, const Patches *patches, const PointView *view,
                           BoxClassFn classify, const void *user, int undecided, int8_t *class_of);

#endif
