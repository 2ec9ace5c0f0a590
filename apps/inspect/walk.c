#include "apps/inspect/walk.h"

/* Draws a stop, so that all passes together have few enough. */
static uint32_t draws_a_stop(const GpList *list)
{
    uint32_t draws = 0;
    for (uint32_t p = 0; p < list->pass_count; p++)
        draws += list->passes[p].draw_count;
    return (draws + WALK_MOST_STOPS - 1) / WALK_MOST_STOPS;
}

uint32_t walk_stops(const GpList *list, WalkStop *out)
{
    const uint32_t each = draws_a_stop(list);
    uint32_t stops = 0;
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpPass *pass = &list->passes[p];
        const bool whole = pass->order != GP_ORDER_SUBMITTED || pass->draw_count == 0;
        const uint32_t step = whole ? pass->draw_count : each;
        uint32_t first = 0;
        do {
            const uint32_t left = pass->draw_count - first;
            const WalkStop stop = { p, first, left < step ? left : step };
            if (out)
                out[stops] = stop;
            stops++;
            first += stop.count;
        } while (first < pass->draw_count);
    }
    return stops;
}

static GpResult run_stop(const Walk *walk, const WalkStop *stop, GpError *error)
{
    GpPass pass = walk->list->passes[stop->pass];
    if (stop->first) {
        for (int i = 0; i < GP_MAX_TARGETS; i++)
            pass.color[i].clear = false;
        pass.depth.clear_depth = pass.depth.clear_stencil = false;
    }
    pass.draws += stop->first;
    pass.draw_count = stop->count;
    return gp_device_run(walk->device, &(GpList){ &pass, 1 }, error);
}

GpResult walk_run(Walk *walk, GpError *error)
{
    const uint32_t total = walk_stops(walk->list, NULL);
    WalkStop *stops = gp_alloc(total, sizeof *stops);
    if (!stops)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the draws of a frame");
    walk_stops(walk->list, stops);
    GpResult result = GP_OK;
    for (uint32_t i = 0; i < total && !result; i++) {
        walk->now = &stops[i];
        result = run_stop(walk, &stops[i], error);
        if (!result && walk->after)
            result = walk->after(walk->user, &stops[i], i, total, error);
    }
    gp_free(stops);
    return result;
}
