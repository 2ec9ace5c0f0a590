#include "apps/inspect/record.h"

#include "apps/inspect/record_choice.h"

enum { MOST_FRAGMENTS = 1 << 23 }; /* a pass: 270 MB */

static void progress(Record *record, const char *text)
{
    const Inspect *inspect = record->inspect;
    if (inspect->progress)
        inspect->progress(inspect->user, record->done, record->total, text);
}

static const GpPass *pass_now(const Record *record)
{
    return &record->inspect->list->passes[record->walk.now->pass];
}

static void take_event(void *user, const GpTraceEvent *event)
{
    Record *record = user;
    const WalkStop *stop = record->walk.now;
    RecordPass *pass = &record->passes[stop->pass];
    const uint32_t draw = stop->first + event->draw;
    if (record->wholly) {
        histories_event(&pass->histories, event, draw);
        return;
    }
    tally_event(&record->tally, event);
    if (event->x >= 0 && event->kind != GP_TRACE_CLEAR)
        fragments_event(&pass->fragments, pass_now(record), event, draw);
}

static bool wants(void *user, int32_t x, int32_t y)
{
    const Record *record = user;
    return !record->wholly ||
           histories_want(&record->passes[record->walk.now->pass].histories, x, y);
}

static bool wants_steps(void *user)
{
    const Record *record = user;
    return histories_want_steps(&record->passes[record->walk.now->pass].histories);
}

static void after_stop(void *user, const WalkStop *stop)
{
    Record *record = user;
    record->done++;
    progress(record, record->wholly ? "pixels' histories" : "draws");
    if (record->wholly)
        return;
    tally_end(&record->tally, record->device);
    json_array_append_new(
        record->passes[stop->pass].stops,
        json_pack("{s:I, s:I, s:o, s:o}", "first", (json_int_t)stop->first, "count",
                  (json_int_t)stop->count, "counters", tally_tell(&record->tally), "targets",
                  targets_changed(&record->targets, pass_now(record), record->blobs)));
    tally_begin(&record->tally, record->device);
}

static GpResult draw_all(void *user, const GpList *draws, GpError *error)
{
    const Record *record = user;
    return gp_device_run(record->device, draws, error);
}

/* The reference executor draws the chosen pixels, for their events; then the fast one draws everything, from what these
 * held before: frames of many pixels take a third of the time that the reference executor takes of all. */
static GpResult draw_chosen(void *user, const GpList *draws, GpError *error)
{
    Record *record = user;
    const GpPass *pass = &draws->passes[0];
    const Histories *histories = &record->passes[record->walk.now->pass].histories;
    GpResult result = held_texels_take(&record->held, pass, histories, error);
    if (!result)
        result = gp_device_run(record->device, draws, error);
    if (result)
        return result;
    held_texels_put(&record->held, pass, histories);
    return gp_device_run(record->fast, draws, error);
}

static GpResult begin_passes(Record *record, GpError *error)
{
    const GpList *list = record->inspect->list;
    record->passes = gp_alloc(list->pass_count, sizeof *record->passes);
    if (!record->passes)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the passes of a frame");
    record->pass_count = list->pass_count;
    for (uint32_t p = 0; p < list->pass_count; p++) {
        Fragments *fragments = &record->passes[p].fragments;
        gp_pass_size(&list->passes[p], &fragments->width, &fragments->height);
        fragments->most = MOST_FRAGMENTS;
        fragments->lod = gp_alloc((size_t)fragments->width * fragments->height, 1);
        record->passes[p].stops = json_array();
    }
    return targets_find(list, &record->targets, error);
}

static GpResult choose_pixels(Record *record, GpError *error)
{
    GpResult result = GP_OK;
    for (uint32_t p = 0; p < record->pass_count && !result; p++)
        result = record_choose(record, p, error);
    if (!result)
        record_choose_alike(record);
    for (uint32_t p = 0; p < record->pass_count && !result; p++)
        result = histories_ask(&record->passes[p].histories, &record->passes[p].fragments, error);
    return result;
}

/* Each walk has a device of its own: shaders are only stepped through in the second. */
static GpResult walk_once(Record *record, bool wholly, GpError *error)
{
    const GpDeviceDesc desc = {
        .executor = GP_EXECUTOR_REFERENCE,
        .trace = { .event = take_event,
                   .user = record,
                   .wants = wants,
                   .wants_steps = wants_steps,
                   .missed = true,
                   .steps = wholly,
                   .without = wholly ? 0
                                     : 1 << GP_TRACE_CLEAR | 1 << GP_TRACE_VERTEX |
                                           1 << GP_TRACE_INTERPOLATE | 1 << GP_TRACE_OUTPUT,
                   .only_wanted = wholly },
    };
    GpResult result = gp_device_create(&desc, &record->device, error);
    if (!result && wholly)
        result = gp_device_create(&(GpDeviceDesc){ .threads = record->inspect->threads },
                                  &record->fast, error);
    record->wholly = wholly;
    record->walk = (Walk){ .list = record->inspect->list,
                           .run = wholly ? draw_chosen : draw_all,
                           .after = after_stop,
                           .user = record };
    if (!result) {
        tally_begin(&record->tally, record->device);
        result = walk_run(&record->walk, error);
    }
    gp_device_destroy(&record->device);
    gp_device_destroy(&record->fast);
    return result;
}

/* The histories of chosen pixels. */
static GpResult walk_wholly(Record *record, GpError *error)
{
    GpResult result = choose_pixels(record, error);
    if (result)
        return result;
    targets_restore(&record->targets);
    result = walk_once(record, true, error);
    for (uint32_t p = 0; p < record->pass_count; p++)
        histories_finish(&record->passes[p].histories);
    return result;
}

GpResult record_frame(const Inspect *inspect, Blobs *blobs, Record *record, GpError *error)
{
    *record = (Record){ .inspect = inspect, .blobs = blobs, .share = 1 };
    record->total = 2 * walk_stops(inspect->list, NULL);
    GpResult result = gp_list_check(inspect->list, error);
    if (!result)
        result = begin_passes(record, error);
    if (!result)
        result = walk_once(record, false, error);
    for (uint32_t p = 0; p < record->pass_count && !result; p++)
        fragments_finish(&record->passes[p].fragments);
    return result ? result : walk_wholly(record, error);
}

GpResult record_fewer(Record *record, double share, GpError *error)
{
    record->share = share;
    record->total += walk_stops(record->inspect->list, NULL);
    for (uint32_t p = 0; p < record->pass_count; p++)
        histories_free(&record->passes[p].histories);
    return walk_wholly(record, error);
}

void record_free(Record *record)
{
    for (uint32_t p = 0; p < record->pass_count; p++) {
        fragments_free(&record->passes[p].fragments);
        histories_free(&record->passes[p].histories);
        json_decref(record->passes[p].stops);
        json_decref(record->passes[p].told);
    }
    gp_free(record->passes);
    held_texels_free(&record->held);
    targets_free(&record->targets);
    *record = (Record){ .inspect = NULL };
}
