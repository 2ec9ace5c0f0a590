#include "apps/inspect/tally.h"

#include <string.h>

static const char *const names[TALLY_KINDS] = {
    "vertices",  "primitives", "outside",   "cut",     "facing",     "zero_area",
    "no_centre", "drawn",      "fragments", "killed",  "clip_plane", "scissor",
    "alpha",     "stencil",    "depth",     "written",
};

void tally_begin(Tally *tally, const GpDevice *device)
{
    *tally = (Tally){ .before = *gp_device_counters(device) };
}

static TallyKind of_setup(const char *reason)
{
    return strcmp(reason, "facing") == 0      ? TALLY_FACING
           : strcmp(reason, "zero area") == 0 ? TALLY_ZERO_AREA
                                              : TALLY_NO_CENTER;
}

static TallyKind of_test(const char *unit)
{
    static const struct {
        const char *unit;
        TallyKind kind;
    } tests[] = { { "clip plane", TALLY_CLIP_PLANE },
                  { "scissor", TALLY_SCISSOR },
                  { "alpha test", TALLY_ALPHA },
                  { "stencil", TALLY_STENCIL } };
    for (size_t i = 0; i < GP_COUNT(tests); i++)
        if (strcmp(unit, tests[i].unit) == 0)
            return tests[i].kind;
    return TALLY_DEPTH;
}

void tally_event(Tally *tally, const GpTraceEvent *event)
{
    if (event->kind == GP_TRACE_CLIP)
        tally->count[TALLY_OUTSIDE] += event->clip.corners == 0;
    else if (event->kind == GP_TRACE_SETUP && event->setup.culled)
        tally->count[of_setup(event->setup.reason)]++;
    else if (event->kind == GP_TRACE_PIXEL)
        tally->count[TALLY_KILLED] += event->pixel.killed;
    else if (event->kind == GP_TRACE_TEST && !event->test.passed)
        tally->count[of_test(event->test.unit)]++;
}

void tally_end(Tally *tally, const GpDevice *device)
{
    const GpCounters *now = gp_device_counters(device), *before = &tally->before;
    tally->count[TALLY_VERTICES] = now->vertices - before->vertices;
    tally->count[TALLY_PRIMITIVES] = now->primitives - before->primitives;
    tally->count[TALLY_CUT] = now->primitives_clipped - before->primitives_clipped;
    tally->count[TALLY_DRAWN] = now->primitives_drawn - before->primitives_drawn;
    tally->count[TALLY_FRAGMENTS] = now->fragments - before->fragments;
    tally->count[TALLY_WRITTEN] = now->pixels_written - before->pixels_written;
}

json_t *tally_tell(const Tally *tally)
{
    json_t *object = json_object();
    for (int i = 0; i < TALLY_KINDS; i++)
        json_object_set_new(object, names[i], json_integer((json_int_t)tally->count[i]));
    return object;
}
