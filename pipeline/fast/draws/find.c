#include "pipeline/fast/draws/find.h"

#include "pipeline/base/search.h"

/* Copies of one mesh are where proportion says: one look, where a search would touch many draws. */
uint32_t fast_find_draw(const FastPass *pass, uint32_t primitive)
{
    const uint32_t guess =
        (uint32_t)((uint64_t)primitive * pass->draw_count / pass->primitive_count);
    const FastDraw *d = &pass->draws[guess];
    if (primitive - d->first_primitive < d->primitive_count)
        return guess;
    return gp_last_at_most(&pass->draws->first_primitive, sizeof *pass->draws, pass->draw_count,
                           primitive);
}

uint32_t fast_find_block(const FastPass *pass, uint32_t block)
{
    return gp_last_at_most(&pass->draws->first_block, sizeof *pass->draws, pass->draw_count, block);
}

const FastPass *fast_find_pass_of_block(const FastGroup *group, uint32_t block)
{
    const FastPass *first = group->passes;
    return first + gp_last_at_most(&first->first_block, sizeof *first, group->pass_count, block);
}

const FastPass *fast_find_pass_of_range(const FastGroup *group, uint32_t range)
{
    const FastPass *first = group->passes;
    return first + gp_last_at_most(&first->first_range, sizeof *first, group->pass_count, range);
}
