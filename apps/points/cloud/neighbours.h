/* The nearest of many points: a tree of boxes over them, each parted at the median of its longest
 * side.
 *
 * source Friedman, Bentley and Finkel, "An algorithm for finding best matches in logarithmic
 *        expected time", 1977; distances to boxes from step to step: Arya and Mount, 1993
 */
#ifndef APPS_POINTS_CLOUD_NEIGHBOURS_H
#define APPS_POINTS_CLOUD_NEIGHBOURS_H

#include "pipeline/base/pool.h"

/* The tree has an order of its own, in which points that are near each other mostly are so in
 * memory: `rank` is a place in that order, `number` one in the array that it was built from. */
typedef struct NeighbourTree {
    float *positions;  /* [3 * count] by rank */
    uint32_t *numbers; /* [count] by rank */
    struct NeighbourNode *nodes;
    uint32_t count;
    int depth;
} NeighbourTree;

typedef struct Neighbour {
    double distance2; /* squared */
    uint32_t rank;
} Neighbour;

enum { NEIGHBOURS_MOST = 32 };

/* in     positions: [3 * count], finite; count: at least 1
 * order  the same for any number of threads
 * errors GP_ERROR_MEMORY
 * owns   the caller, until neighbour_tree_free */
GpResult neighbour_tree_build(const float *positions, uint32_t count, GpPool *pool,
                              NeighbourTree *tree);

/* Frees and zeroes; a zeroed one is fine. */
void neighbour_tree_free(NeighbourTree *tree);

/* Finds the points nearest to one of them, which is left out.
 * in   most: at most NEIGHBOURS_MOST; known: how many `found` has of the rank before, as this left
 *      it, which bounds the search; 0: none
 * out  found: nearest first; of points at one distance that of the lowest number
 * returns their count: as many as there are, up to `most` */
uint32_t neighbours_of(const NeighbourTree *tree, uint32_t rank, uint32_t most, uint32_t known,
                       Neighbour *found);

/* All ranks in pieces, which do not depend on the count of threads: items of gp_pool_run. */
enum { NEIGHBOURS_PIECE = 2048 };

static inline uint32_t neighbour_pieces(uint32_t count)
{
    return count / NEIGHBOURS_PIECE + (count % NEIGHBOURS_PIECE > 0);
}

/* The ranks of a piece: *begin up to the returned. */
static inline uint32_t neighbour_piece(uint32_t count, uint32_t piece, uint32_t *begin)
{
    *begin = piece * NEIGHBOURS_PIECE;
    return count - *begin < NEIGHBOURS_PIECE ? count : *begin + NEIGHBOURS_PIECE;
}

#endif
