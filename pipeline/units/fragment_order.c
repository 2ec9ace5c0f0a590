/* Fragment order: the key by which a pixel's fragments are sorted.
 * in: a depth, the viewport's range, the pass's order; out: a number of 31 bits. Rules R18, R55. */
#include "pipeline/units/fragment_order.h"

#include "pipeline/resources/format.h"

/* Codes of D32F rise with depth, whatever format the pass's depth target has. */
uint32_t gp_order_key(GpOrder order, float depth, float min_depth, float max_depth)
{
    depth = depth < min_depth ? min_depth : depth > max_depth ? max_depth : depth;
    const uint32_t code = gp_depth_code(GP_D32F, depth);
    return order == GP_ORDER_DEPTH_NEAR_FIRST ? code : GP_ORDER_KEY_MOST - code;
}

float gp_order_depth(GpOrder order, uint32_t key)
{
    const uint32_t code = order == GP_ORDER_DEPTH_NEAR_FIRST ? key : GP_ORDER_KEY_MOST - key;
    return gp_depth_from_code(GP_D32F, code);
}
