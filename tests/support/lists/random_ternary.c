#include "tests/support/lists/random_ternary.h"

#include "tests/support/random.h"
#include "tests/support/random_geometry.h"

static float random_epsilon(Random *r)
{
    const int kind = random_int(r, 0, 5);
    if (kind == 0)
        return 0;
    if (kind == 1)
        return random_float(r, 0, 0x1p-15f); /* some codes, or none */
    return random_float(r, 0, kind == 2 ? 1.5f : 0.2f);
}

static void make_ternary(Random *r, GpDraw *draw)
{
    GpState *state = &draw->state;
    state->depth = (GpDepthState){ GP_LESS_EQUAL, true, true, 0 };
    state->depth.epsilon = random_epsilon(r);
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        if (random_chance(r, 50))
            state->blend[i] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
}

bool random_ternary_add(uint64_t seed, RandomList *random)
{
    Random r = { seed * 0xa0761d6478bd642fu + 3 };
    for (uint32_t p = 0; p < random->list.pass_count; p++)
        for (uint32_t i = 0; random->passes[p].depth.surface && i < random->passes[p].draw_count;
             i++)
            if (random_chance(&r, 80))
                make_ternary(&r, &random->draws[p][i]);
    return true;
}
