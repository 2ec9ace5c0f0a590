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

static GpResult after_stop(void *user, const WalkStop *stop, uint32_t number, uint32_t total,
                           GpError *error)
{
    Record *record = user;
    (void)number, (void)total, (void)error;
    record->done++;
    progress(record, record->wholly ? "pixels' histories" : "draws");
    if (record->wholly)
        return GP_OK;
    tally_end(&record->tally, record->walk.device);
    json_array_append_new(
        record->passes[stop->pass].stops,
        json_pack("{s:I, s:I, s:o, s:o}", "first", (json_int_t)stop->first, "count",
                  (json_int_t)stop->count, "counters", tally_tell(&record->tally), "targets",
                  targets_changed(&record->targets, pass_now(record), record->blobs)));
    tally_begin(&record->tally, record->walk.device);
    return GP_OK;
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

/* Each walk has a device of its own: shaders are only stepped through in the second, which only
 * tells of chosen pixels. */
static GpResult walk_once(Record *record, bool wholly, GpError *error)
{
    const GpDeviceDesc desc = {
        .executor = wholly ? GP_EXECUTOR_FAST : GP_EXECUTOR_REFERENCE,
        .threads = record->inspect->threads,
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
    GpDevice *device = NULL;
    GpResult result = gp_device_create(&desc, &device, error);
    if (result)
        return result;
    record->wholly = wholly;
    record->walk = (Walk){
        .list = record->inspect->list, .device = device, .after = after_stop, .user = record
    };
    tally_begin(&record->tally, device);
    result = walk_run(&record->walk, error);
    gp_device_destroy(&device);
    return result;
}

/* The histories of chosen pixels. */
static GpResult walk_wholly(Record *record, GpError *error)
{
    targets_restore(&record->targets);
    const GpResult result = walk_once(record, true, error);
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
    if (!result)
        result = record_choose(record, error);
    return result ? result : walk_wholly(record, error);
}

GpResult record_fewer(Record *record, double part, GpError *error)
{
    record->total += walk_stops(record->inspect->list, NULL);
    const GpResult result = record_choose_fewer(record, part, error);
    return result ? result : walk_wholly(record, error);
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
    targets_free(&record->targets);
    *record = (Record){ .inspect = NULL };
}
