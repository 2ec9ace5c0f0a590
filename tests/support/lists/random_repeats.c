#include "tests/support/lists/random_repeats.h"

#include "tests/support/random.h"
#include "tests/support/random_geometry.h"

#include <string.h>

/* Another program with the same vertex shader, now and then. */
static const GpProgram *sibling(Random *r, const GpProgram *program)
{
    static const GpProgram *const families[][4] = {
        { &exercise_color, &exercise_targets2, &exercise_targets4, &exercise_position },
        { &exercise_discard, &exercise_depth, &exercise_math, &exercise_derivatives },
        { &exercise_texture, &exercise_local, &exercise_local, &exercise_dependent },
    };
    const int other = random_int(r, 0, 3);
    for (size_t family = 0; family < GP_COUNT(families); family++)
        for (int i = 0; i < 4; i++)
            if (families[family][i] == program && random_chance(r, 70))
                return families[family][other];
    return program;
}

/* What is shaded in order is what executors keep from pass to pass. */
static void add_in_order(GpDraw *draw)
{
    draw->state.stencil.enable = draw->state.depth.ternary = false;
    draw->state.depth.epsilon = 0;
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        draw->state.blend[i] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
}

/* The draws of an earlier pass become those of a later one, which keeps its states and textures. */
static void repeat(Random *r, RandomList *random, uint32_t from, uint32_t to)
{
    GpPass *pass = &random->passes[to];
    const uint32_t count = pass->draw_count, repeated = random->passes[from].draw_count;
    GpDraw before[RANDOM_DRAWS], others[RANDOM_DRAWS];
    memcpy(before, random->draws[to], sizeof before);
    memcpy(others, random->draws[from], sizeof others);
    for (uint32_t i = 0; i < repeated; i++) {
        GpDraw *draw = &random->draws[to][i];
        *draw = random->draws[from][i];
        draw->program = sibling(r, draw->program);
        if (i >= count)
            continue;
        memcpy(draw->textures, before[i].textures, sizeof draw->textures);
        const GpRasterState raster = draw->state.raster;
        draw->state = before[i].state;
        draw->state.raster = raster;
        if (random_chance(r, 60)) {
            add_in_order(draw);
            add_in_order(&random->draws[from][i]);
        }
    }
    pass->draw_count = repeated;
    if (gp_list_check(&random->list, NULL) == GP_OK)
        return;
    memcpy(random->draws[to], before, sizeof before);
    memcpy(random->draws[from], others, sizeof others);
    pass->draw_count = count;
}

void random_repeats_add(uint64_t seed, RandomList *random)
{
    Random r = { seed * 0x8ebc6af09c88c6e3u + 9 };
    for (uint32_t p = 1; p < random->list.pass_count; p++) {
        const uint32_t from = (uint32_t)random_int(&r, 0, (int32_t)p - 1);
        if (random_chance(&r, 80))
            repeat(&r, random, random_chance(&r, 60) ? p - 1 : from, p);
    }
}
