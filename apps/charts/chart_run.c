#include "apps/charts/chart_run.h"
#include "apps/charts/chart_file.h"
#include "apps/charts/chart_pictures.h"

#include "apps/base/machine.h"
#include "apps/techniques/timed_setting.h"

#include <stdio.h>
#include <string.h>

/* What the settings of one chart share. */
typedef struct Run {
    const ChartJob *job;
    void *scene;
    TechniqueClock clock;
    ChartPoint *settings; /* [total], of the sweep: method and options */
    uint32_t total;
    Chart chart;
    GpError *error;
} Run;

/* --- one setting ------------------------------------------------------------------------------ */

/* Builds a setting's frame and draws it for the first time. in frame: zeroed; to be freed always */
static GpResult draw_first(const Run *run, const char *options, GpDevice *device, Frame *frame,
                           RunStatistics *statistics, bool *goes, GpError *error)
{
    const Technique *technique = run->job->technique;
    void *setting;
    GpResult result = technique_setting(technique, options, &setting, error);
    if (result)
        return result; /* the sweep is wrong, not the scene */
    result = technique->build(run->scene, setting, device, frame, error);
    gp_free(setting);
    *goes = result != GP_ERROR_INVALID;
    return result ? result : run_first(device, &frame->list, statistics, error);
}

/* What a setting comes to, as bytes: the same each time as far as `time'. */
typedef struct Measurement {
    uint32_t goes, width, height, none;
    TechniqueError measured;
    char reason[256]; /* why it does not go with the scene */
    Timing time;
    char isa[16];
    int32_t threads;
} Measurement;

static void describe_frame(const Run *run, const Frame *frame, const RunStatistics *statistics,
                           Measurement *made)
{
    const GpSurface *picture = frame_picture(frame);
    const bool is_picture = !run->job->technique->volume;
    made->width = is_picture ? picture->width : 0;
    made->height = is_picture ? picture->height : 0;
    made->threads = statistics->threads;
    text_copy(made->isa, sizeof made->isa, statistics->isa);
}

/* The error belongs to the first frame, the times to those after it. */
static GpResult measure(const Run *run, const Frame *frame, GpDevice *device,
                        RunStatistics *statistics, Measurement *made, GpError *error)
{
    describe_frame(run, frame, statistics, made);
    GpResult result = run->job->experiment->measure(run->scene, frame, &made->measured, error);
    if (!result)
        result = timing_run(device, &frame->list, &run->clock.plan, run->clock.each, statistics,
                            &made->time, error);
    return result;
}

static void tell(const void *context, uint32_t item, char name[ITEM_NAME])
{
    const Run *run = context;
    snprintf(name, ITEM_NAME, "%.90s", run->settings[item].options);
}

static GpResult draw(const void *context, uint32_t item, const ItemTools *tools, GpBytes *bytes,
                     size_t *same, GpError *error)
{
    const Run *run = context;
    Measurement made;
    Frame frame = { .color = NULL };
    RunStatistics statistics = { .isa = "" };
    bool goes = true;
    memset(&made, 0, sizeof made); /* with what lies between its members */
    GpResult result = draw_first(run, run->settings[item].options, tools->device, &frame,
                                 &statistics, &goes, error);
    if (!result)
        result = measure(run, &frame, tools->device, &statistics, &made, error);
    frame_free(&frame);
    made.goes = goes;
    if (!goes) { /* no error of the run */
        text_copy(made.reason, sizeof made.reason, error->text);
        error->text[0] = '\0';
    } else if (result)
        return result;
    gp_bytes_append(bytes, &made, sizeof made);
    *same = offsetof(Measurement, time);
    return GP_OK;
}

static void tell_progress(const Run *run, uint32_t done, const char *text)
{
    const ChartListener *listener = &run->job->listener;
    if (listener->progress)
        listener->progress(listener->user, done, run->total, text);
}

static void tell_left_out(const Run *run, const ChartPoint *setting, const char *reason)
{
    char line[1024];
    const ChartListener *listener = &run->job->listener;
    tell_progress(run, run->total, "");
    snprintf(line, sizeof line, "%s, %s: left out: %s", setting->method, setting->options, reason);
    if (listener->notice)
        listener->notice(listener->user, line);
}

/* Adds the point of a setting, unless it does not go with the scene. */
static GpResult take(void *context, uint32_t item, const void *bytes, size_t size, GpError *error)
{
    Run *run = context;
    Chart *chart = &run->chart;
    Measurement made;
    if (size != sizeof made)
        return gp_fail(error, GP_ERROR_FORMAT, "the result of a setting came damaged");
    memcpy(&made, bytes, sizeof made);
    if (!made.goes) {
        tell_left_out(run, &run->settings[item], made.reason);
        return GP_OK;
    }
    ChartPoint *point = &chart->points[chart->count++];
    *point = run->settings[item];
    point->measured = made.measured;
    point->time = made.time;
    chart->width = made.width;
    chart->height = made.height;
    chart->threads = made.threads;
    text_copy(chart->isa, sizeof chart->isa, made.isa);
    return GP_OK;
}

/* --- the sweep -------------------------------------------------------------------------------- */

static GpResult list_method(Run *run, const TechniqueSweep *sweep, uint32_t *number)
{
    size_t count = 0;
    SettingText *texts = NULL;
    GpResult result = technique_expand_all(sweep->options, &texts, &count, run->error);
    for (size_t i = 0; i < count && !result; i++) {
        ChartPoint *setting = &run->settings[(*number)++];
        text_copy(setting->method, sizeof setting->method, sweep->method);
        text_copy(setting->options, sizeof setting->options, texts[i]);
    }
    gp_free(texts);
    return result;
}

static GpResult list_all(Run *run)
{
    const TechniqueSweep *sweep = run->job->experiment->sweep;
    for (size_t i = 0; sweep[i].method; i++)
        run->total += (uint32_t)technique_expand(sweep[i].options, NULL, 0);
    GP_ASSERT(run->total <= CHART_MAX_POINTS);
    run->settings = gp_alloc(run->total, sizeof *run->settings);
    run->chart.points = gp_alloc(run->total, sizeof *run->chart.points);
    if (!run->settings || !run->chart.points)
        return gp_fail(run->error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = GP_OK;
    uint32_t number = 0;
    for (size_t i = 0; sweep[i].method && !result; i++)
        result = list_method(run, &sweep[i], &number);
    return result;
}

static GpResult run_alone(Run *run, const ItemWork *work)
{
    const ItemTools tools = { .device = run->job->device };
    GpResult result = GP_OK;
    for (uint32_t i = 0; i < work->count && !result; i++) {
        GpBytes bytes = { .data = NULL };
        size_t same;
        tell_progress(run, i, run->settings[i].options);
        result = work->draw(run, i, &tools, &bytes, &same, run->error);
        if (!result)
            result = work->take(run, i, bytes.data, bytes.size, run->error);
        gp_free(bytes.data);
    }
    tell_progress(run, run->total, "");
    return result;
}

static GpResult sweep_all(Run *run)
{
    GpResult result = list_all(run);
    if (result)
        return result;
    const ItemWork work = { .count = run->total,
                            .in_order = true,
                            .measures = true,
                            .context = run,
                            .tell = tell,
                            .draw = draw,
                            .take = take };
    if (!run->job->run)
        result = run_alone(run, &work);
    else
        switch (items_run(&work, run->job->run, run->error)) {
        case ITEMS_DONE:
            break;
        case ITEMS_USAGE:
            return GP_ERROR_UNSUPPORTED;
        case ITEMS_INPUT:
            return GP_ERROR_FORMAT;
        default:
            return GP_ERROR_MEMORY;
        }
    if (!result && run->chart.count == 0)
        return gp_fail(run->error, GP_ERROR_INVALID, "%.200s: no setting goes with this scene",
                       run->job->scene);
    chart_mark_best(&run->chart);
    return result;
}

/* --- pictures --------------------------------------------------------------------------------- */

static GpResult write_pictures(Run *run)
{
    const ChartJob *job = run->job;
    char stem[64];
    chart_name(job->experiment, job->scene, stem, sizeof stem);
    const ChartPictures pictures = { .technique = job->technique,
                                     .experiment = job->experiment,
                                     .scene = run->scene,
                                     .folder = job->folder,
                                     .stem = job->name ? job->name : stem,
                                     .device = job->device };
    return chart_write_pictures(&pictures, &run->chart, run->error);
}

/* --- all of it -------------------------------------------------------------------------------- */

static void describe(const ChartJob *job, Chart *chart)
{
    const Experiment *experiment = job->experiment;
    text_copy(chart->technique, sizeof chart->technique, experiment->name);
    text_copy(chart->title, sizeof chart->title, experiment->title);
    text_copy(chart->scene, sizeof chart->scene, job->scene);
    text_copy(chart->error_name, sizeof chart->error_name, experiment->error_name);
    for (int i = 0; experiment->metrics && experiment->metrics[i]; i++) {
        GP_ASSERT(i < TECHNIQUE_MAX_METRICS);
        text_copy(chart->metrics[i], sizeof chart->metrics[i], experiment->metrics[i]);
        chart->metric_count = i + 1;
    }
    machine_describe(chart->machine, sizeof chart->machine);
}

static GpResult run_opened(Run *run)
{
    const ChartJob *job = run->job;
    GpResult result = technique_clock_open(job->device, job->seconds, &run->clock, run->error);
    if (!result)
        result =
            job->experiment->find_truth(run->scene, gp_device_threads(job->device), run->error);
    const MachineLoad load = machine_load_begin();
    if (!result)
        result = sweep_all(run);
    run->chart.others = machine_others(&load);
    if (result || !job->folder)
        return result;
    result = write_pictures(run);
    if (job->is_unwritten)
        *job->is_unwritten = result == GP_ERROR_IO;
    return result;
}

GpResult chart_run(const ChartJob *job, Chart *chart, GpError *error)
{
    Run run = { .job = job, .error = error };
    GpResult result =
        technique_open(job->technique, job->scene, job->width, job->height, &run.scene, error);
    if (result)
        return result;
    describe(job, &run.chart);
    result = run_opened(&run);
    job->technique->close(run.scene);
    gp_free(run.clock.each);
    gp_free(run.settings);
    if (result)
        chart_free(&run.chart);
    else
        *chart = run.chart;
    return result;
}
