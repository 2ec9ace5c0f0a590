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
    uint32_t total; /* settings of the sweep */
    Chart chart;
    GpError *error;
} Run;

/* --- one setting ------------------------------------------------------------------------------ */

/* Builds a setting's frame and draws it for the first time. in frame: zeroed; to be freed always */
static GpResult draw_first(const Run *run, const char *options, Frame *frame,
                           RunStatistics *statistics, bool *goes, GpError *error)
{
    const Technique *technique = run->job->technique;
    GpDevice *device = run->job->device;
    void *setting;
    GpResult result = technique_setting(technique, options, &setting, error);
    if (result)
        return result; /* the sweep is wrong, not the scene */
    result = technique->build(run->scene, setting, device, frame, error);
    gp_free(setting);
    *goes = result != GP_ERROR_INVALID;
    return result ? result : run_first(device, &frame->list, statistics, error);
}

static void describe_frame(Chart *chart, bool is_picture, const Frame *frame,
                           const RunStatistics *statistics)
{
    const GpSurface *picture = frame_picture(frame);
    chart->width = is_picture ? picture->width : 0;
    chart->height = is_picture ? picture->height : 0;
    chart->threads = statistics->threads;
    text_copy(chart->isa, sizeof chart->isa, statistics->isa);
}

/* The error belongs to the first frame, the times to those after it. */
static GpResult measure(Run *run, const Frame *frame, RunStatistics *statistics, ChartPoint *point)
{
    const TechniqueClock *clock = &run->clock;
    describe_frame(&run->chart, !run->job->technique->volume, frame, statistics);
    GpResult result =
        run->job->experiment->measure(run->scene, frame, &point->measured, run->error);
    if (!result)
        result = timing_run(clock->device, &frame->list, &clock->plan, clock->each, statistics,
                            &point->time, run->error);
    return result;
}

static void tell_progress(const Run *run, uint32_t done, const char *text)
{
    const ChartListener *listener = &run->job->listener;
    if (listener->progress)
        listener->progress(listener->user, done, run->total, text);
}

static void tell_left_out(const Run *run, const char *method, const char *options)
{
    char line[1024];
    const ChartListener *listener = &run->job->listener;
    tell_progress(run, run->total, "");
    snprintf(line, sizeof line, "%s, %s: left out: %s", method, options, run->error->text);
    if (listener->notice)
        listener->notice(listener->user, line);
}

/* Adds the point of a setting, unless it does not go with the scene. */
static GpResult add_point(Run *run, const char *method, const char *options)
{
    Chart *chart = &run->chart;
    ChartPoint *point = &chart->points[chart->count];
    Frame frame = { .color = NULL };
    RunStatistics statistics = { .isa = "" };
    bool goes = true;
    text_copy(point->method, sizeof point->method, method);
    text_copy(point->options, sizeof point->options, options);
    GpResult result = draw_first(run, options, &frame, &statistics, &goes, run->error);
    if (!result)
        result = measure(run, &frame, &statistics, point);
    frame_free(&frame);
    if (!result)
        chart->count++;
    if (goes)
        return result;
    tell_left_out(run, method, options);
    run->error->text[0] = '\0';
    return GP_OK;
}

/* --- the sweep -------------------------------------------------------------------------------- */

static GpResult sweep_method(Run *run, const TechniqueSweep *sweep, uint32_t *number)
{
    size_t count = 0;
    SettingText *texts = NULL;
    GpResult result = technique_expand_all(sweep->options, &texts, &count, run->error);
    for (size_t i = 0; i < count && !result; i++) {
        tell_progress(run, (*number)++, texts[i]);
        result = add_point(run, sweep->method, texts[i]);
    }
    gp_free(texts);
    return result;
}

static GpResult sweep_all(Run *run)
{
    const TechniqueSweep *sweep = run->job->experiment->sweep;
    for (size_t i = 0; sweep[i].method; i++)
        run->total += (uint32_t)technique_expand(sweep[i].options, NULL, 0);
    GP_ASSERT(run->total <= CHART_MAX_POINTS);
    run->chart.points = gp_alloc(run->total, sizeof *run->chart.points);
    if (!run->chart.points)
        return gp_fail(run->error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = GP_OK;
    uint32_t number = 0;
    for (size_t i = 0; sweep[i].method && !result; i++)
        result = sweep_method(run, &sweep[i], &number);
    tell_progress(run, run->total, "");
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
    if (!result && job->folder)
        result = write_pictures(run);
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
    if (result)
        chart_free(&run.chart);
    else
        *chart = run.chart;
    return result;
}
