/* Fragment order: a pixel's fragments, sorted by depth (CONVENTIONS.md, Sorted fragments). */
#ifndef GP_FRAGMENT_ORDER_H
#define GP_FRAGMENT_ORDER_H

#include "pipeline/resources/packet.h"

/* Keys are up to this. */
#define GP_ORDER_KEY_MOST 0x7fffffffu

/* The key of a fragment in a pass with an order by depth: of two in one pixel the lesser has its
 * turn first, and of equal ones the one that was submitted first.
 * in   depth: any number; is clamped as for the depth test (R18); NaN is behind all others
 * source ours; PowerVR's CLX2 (1998) sorted a tile's translucent layers */
uint32_t gp_order_key(GpOrder order, float depth, float min_depth, float max_depth);

/* The depth that a key was made of, clamped. */
float gp_order_depth(GpOrder order, uint32_t key);

#endif
