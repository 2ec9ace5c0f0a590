/* One complete binary tree over all surfels, split by the covariance: the order of its leaves.
 *
 * Node k of depth d holds leaves floor(k n / 2^d) to floor((k + 1) n / 2^d): halves differ by one
 * at most, every depth but the last is full, and no node needs to be stored to be found. The leaves
 * of a node are parted at the median along the axis of their largest spread, so that nodes are
 * about as long as wide.
 *
 * source Dong Zhao's thesis, 3.2.2; Pauly, Gross and Kobbelt, "Efficient simplification of
 *        point-sampled surfaces", IEEE Visualization 2002, for the plane
 */
#ifndef APPS_POINTS_TREE_H
#define APPS_POINTS_TREE_H

#include "apps/points/cloud/complete_tree.h"
#include "apps/points/surfels.h"
#include "pipeline/base/pool.h"

/* Hears how far a long work is, from the thread that began it; a zeroed one hears nothing. */
typedef struct PointsListener {
    void (*progress)(const void *user, uint32_t done, uint32_t total, const char *text);
    const void *user;
} PointsListener;

static inline void points_tell(const PointsListener *listener, uint32_t done, uint32_t total,
                               const char *text)
{
    if (listener && listener->progress)
        listener->progress(listener->user, done, total, text);
}

/* Puts surfels into the order of the tree's leaves; inside a node of tree_depth in that of the
 * surfels themselves.
 * in     listener: NULL: none
 * out    order: [surfels->count] numbers of surfels, each once
 * order  the same for any number of threads; equal places are told apart by number
 * errors GP_ERROR_MEMORY */
GpResult tree_order(const Surfels *surfels, GpPool *pool, const PointsListener *listener,
                    uint32_t *order);

#endif
