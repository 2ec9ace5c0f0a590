/* Which draw or pass an item belongs to: the last whose first item is not above it. */
#ifndef GP_FAST_FIND_H
#define GP_FAST_FIND_H

#include "pipeline/fast/draws/group.h"

/* Of a pass. */
uint32_t fast_find_draw(const FastPass *pass, uint32_t primitive);
uint32_t fast_find_block(const FastPass *pass, uint32_t block);

/* Of a group. */
const FastPass *fast_find_pass_of_block(const FastGroup *group, uint32_t block);
const FastPass *fast_find_pass_of_range(const FastGroup *group, uint32_t range);

#endif
