#include "apps/charts/scaling_run.h"

#include "apps/base/machine.h"
#include "apps/base/text.h"
#include "apps/techniques/timed_setting.h"

#include <stdio.h>
#include <string.h>

/* What all lines share. */
typedef struct Run {
    const ChartListener *listener;
    TechniqueClock clock;
    Scaling scaling;
    Text missing; /* scenes without a file, a line each */
    GpError *error;
} Run;

static size_t count_points(const TechniqueScaling *table)
{
    size_t count = 0;
    for (int p = 0; p < TECHNIQUE_PANELS; p++)
        for (const TechniqueLine *line = table->panels[p].lines; line->name; line++)
            count +=
                technique_expand(line->scenes, NULL, 0) * technique_expand(line->options, NULL, 0);
    return count;
}

/* Measures a setting as the next point. */
static GpResult add_point(Run *run, ScalingPoint point, void *scene, const char *options)
{
    Scaling *scaling = &run->scaling;
    const Technique *technique = scaling->technique;
    Frame frame = { .color = NULL };
    GpResult result =
        technique_time(&run->clock, technique, scene, options, &frame, &point.time, run->error);
    if (result)
        return result;
    text_copy(point.options, sizeof point.options, options);
    point.amount = technique->scaling->panels[point.panel].amount(scene, &frame);
    scaling->points[scaling->count++] = point;
    scaling->threads = gp_device_threads(run->clock.device);
    text_copy(scaling->isa, sizeof scaling->isa, gp_device_isa(run->clock.device));
    frame_free(&frame);
    return GP_OK;
}

/* Says so once for each scene. */
static void leave_out(Run *run, const char *path)
{
    char line[SETTING_MAX_TEXT + 1], message[640];
    snprintf(line, sizeof line, "%s\n", path);
    if (run->missing.data && strstr(run->missing.data, line))
        return;
    text_add(&run->missing, "%s", line);
    snprintf(message, sizeof message, "left out: %s", run->error->text);
    if (run->listener->notice)
        run->listener->notice(run->listener->user, message);
}

/* The settings of a line on one of its scenes. */
static GpResult run_scene(Run *run, int panel, int line, const char *path)
{
    const Technique *technique = run->scaling.technique;
    void *scene;
    SettingText *options;
    size_t count;
    GpResult result = technique_open(technique, path, 0, 0, &scene, run->error);
    if (result == GP_ERROR_IO) {
        leave_out(run, path);
        return GP_OK;
    }
    if (result)
        return result;
    ScalingPoint point = { .panel = panel, .line = line };
    text_copy(point.scene, sizeof point.scene, path);
    result = technique_expand_all(technique->scaling->panels[panel].lines[line].options, &options,
                                  &count, run->error);
    for (size_t i = 0; i < count && !result; i++)
        result = add_point(run, point, scene, options[i]);
    gp_free(options);
    technique->close(scene);
    return result;
}

static GpResult run_panel(Run *run, int panel)
{
    const TechniqueLine *lines = run->scaling.technique->scaling->panels[panel].lines;
    GpResult result = GP_OK;
    for (int line = 0; lines[line].name && !result; line++) {
        SettingText *scenes;
        size_t count;
        result = technique_expand_all(lines[line].scenes, &scenes, &count, run->error);
        for (size_t i = 0; i < count && !result; i++)
            result = run_scene(run, panel, line, scenes[i]);
        gp_free(scenes);
    }
    return result;
}

GpResult scaling_run(const Technique *technique, GpDevice *device, const ChartListener *listener,
                     double seconds, Scaling *scaling, GpError *error)
{
    Run run = { .listener = listener, .error = error };
    const MachineLoad load = machine_load_begin();
    GpResult result = technique_clock_open(device, seconds, &run.clock, error);
    run.scaling.technique = technique;
    run.scaling.points = gp_alloc(count_points(technique->scaling), sizeof *run.scaling.points);
    machine_describe(run.scaling.machine, sizeof run.scaling.machine);
    if (!result && !run.scaling.points)
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (int panel = 0; panel < TECHNIQUE_PANELS && !result; panel++)
        result = run_panel(&run, panel);
    if (!result && run.scaling.count == 0)
        result = GP_ERROR_IO; /* the last scene's message is there */
    run.scaling.others = machine_others(&load);
    gp_free(run.clock.each);
    text_free(&run.missing);
    if (result)
        scaling_free(&run.scaling);
    else
        *scaling = run.scaling;
    return result;
}
