#include "tests/support/lists/random_order.h"

#include "tests/support/random.h"
#include "tests/support/random_geometry.h"

/* What passes of transparent things do: tests are then as early as ever. */
static void leave_depth_alone(GpDraw *draw)
{
    draw->state.depth.ternary = draw->state.depth.write = false;
    draw->state.depth.epsilon = 0;
    draw->state.stencil.enable = false;
}

bool random_order_add(uint64_t seed, RandomList *random)
{
    Random r = { seed * 0xd6e8feb86659fd93u + 5 };
    for (uint32_t p = 0; p < random->list.pass_count; p++) {
        GpPass *pass = &random->passes[p];
        if (!random_chance(&r, 80))
            continue;
        pass->order = random_chance(&r, 70) ? GP_ORDER_DEPTH : GP_ORDER_DEPTH_NEAR_FIRST;
        const bool alone = random_chance(&r, 50);
        for (uint32_t i = 0; alone && i < pass->draw_count; i++)
            leave_depth_alone(&random->draws[p][i]);
        for (uint32_t i = 0; i < pass->draw_count; i++)
            if (random_chance(&r, 30) && pass->color[0].surface)
                random->draws[p][i].program = &exercise_flat; /* takes the same inputs */
    }
    return true;
}
