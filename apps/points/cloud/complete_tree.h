/* Complete binary trees, whose nodes need not be stored to be found: node k of depth d holds leaves
 * floor(k n / 2^d) to floor((k + 1) n / 2^d). */
#ifndef APPS_POINTS_CLOUD_COMPLETE_TREE_H
#define APPS_POINTS_CLOUD_COMPLETE_TREE_H

#include <stdint.h>

/* The first leaf of a node, or of the leaves behind the last: node <= 2^depth, depth < 32. */
static inline uint32_t tree_bound(uint32_t leaves, int depth, uint64_t node)
{
    return (uint32_t)((uint64_t)leaves * node >> depth);
}

/* The depth below which nodes are not parted: they have 4 to 8 leaves there. -1: fewer than four
 * leaves in all, which are no tree. */
static inline int tree_depth(uint32_t leaves)
{
    int depth = -1;
    while (leaves >= 4u << (depth + 1) && depth < 29)
        depth++;
    return depth;
}

#endif
