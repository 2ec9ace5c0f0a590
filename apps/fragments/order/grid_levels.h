/* Levels of sides and slabs that come one after the other. */
#ifndef APPS_FRAGMENTS_ORDER_GRID_LEVELS_H
#define APPS_FRAGMENTS_ORDER_GRID_LEVELS_H

#include "apps/fragments/order/order.h"
#include "apps/fragments/order/parting.h"

/* Each gets the first place behind all before it that share a part of the screen with it: a level
 * has near sides, then far sides, then slabs, which are its knots.
 * in     sequence: [node_count]: the near side of piece p is node 2 p, its far side 2 p + 1; then
 *        come slabs
 * out    order: zeroed but for what is known already. errors GP_ERROR_MEMORY */
GpResult grid_levels(const Pieces *pieces, const Partings *partings, const FragmentView *view,
                     const Screen *screen, const uint32_t *sequence, uint32_t node_count,
                     Order *order);

#endif
