#include "pipeline/watched.h"

#include "pipeline/reference/held_quads.h"

static GpResult watch_pass(const GpReference *reference, const GpPass *pass, uint32_t number,
                           GpError *error)
{
    GpHeldQuads held;
    GpCounters uncounted = { 0 };
    GpReference watching = *reference;
    watching.counters = &uncounted;
    watching.first_pass = number;
    watching.held = &held;
    GpResult result = gp_held_begin(&held, pass, error);
    if (!result) {
        result = gp_reference_run(&watching, &(GpList){ (GpPass *)pass, 1 }, error);
        gp_held_put(&held);
    }
    if (!result && held.failed)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for the quads that are watched");
    gp_held_free(&held);
    return result;
}

GpResult gp_watched_run(const GpReference *reference, GpFast *fast, const GpList *list, int lanes,
                        bool timed, GpCounters *counters, GpPhases *phases, GpError *error)
{
    const GpTrace *trace = reference->trace;
    GpResult result = GP_OK;
    for (uint32_t p = 0, end; p < list->pass_count && !result; p = end) {
        if (!trace->one_pass || trace->pass == p)
            result = watch_pass(reference, &list->passes[p], p, error);
        end = p + 1; /* with it, those behind it that nobody watches */
        while (end < list->pass_count && trace->one_pass && trace->pass != end)
            end++;
        const GpList part = { list->passes + p, end - p };
        if (!result)
            result = gp_fast_check(fast, &part, lanes, error);
        if (!result)
            result = gp_fast_run(fast, &part, lanes, timed, counters, phases, error);
    }
    return result;
}
