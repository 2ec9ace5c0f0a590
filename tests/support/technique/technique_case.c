#include "tests/support/technique/technique_case.h"

#include "tests/support/devices.h"
#include "tests/support/scene_text.h"

#include <math.h>

enum { THREADS = 2 };

/* --- scenes ----------------------------------------------------------------------------------- */

static GpResult open_scene(const Technique *technique, const char *scene, uint32_t width,
                           uint32_t height, void **opened, GpError *error)
{
    char path[TEMPORARY_PATH], text[8192];
    if (scene[0] != '{')
        return technique_open(technique, scene, width, height, opened, error);
    const size_t length = strlen(scene);
    assert_true(length < sizeof text);
    for (size_t i = 0; i < length; i++)
        text[i] = scene[i] == '\'' ? '"' : scene[i];
    put_temporary(text, length, path);
    GpResult result = technique_open(technique, path, width, height, opened, error);
    unlink(path);
    return result;
}

/* --- a stage ---------------------------------------------------------------------------------- */

GpResult technique_stage_open(const Technique *technique, const char *scene, uint32_t width,
                              uint32_t height, TechniqueStage *stage, GpError *error)
{
    *stage = (TechniqueStage){ .technique = technique };
    GpResult result =
        gp_device_create(&(GpDeviceDesc){ .threads = THREADS }, &stage->device, error);
    if (!result)
        result = open_scene(technique, scene, width, height, &stage->scene, error);
    if (!result)
        result = technique->experiments->find_truth(stage->scene, THREADS, error);
    if (result)
        technique_stage_close(stage);
    return result;
}

void technique_stage_close(TechniqueStage *stage)
{
    if (stage->scene)
        stage->technique->close(stage->scene);
    gp_device_destroy(&stage->device);
    *stage = (TechniqueStage){ 0 };
}

GpResult technique_stage_draw(const TechniqueStage *stage, const char *options, Frame *frame,
                              GpError *error)
{
    *frame = (Frame){ .color = NULL };
    GpResult result =
        technique_build(stage->technique, stage->scene, options, stage->device, frame, error);
    if (!result)
        result = gp_device_run(stage->device, &frame->list, error);
    if (result)
        frame_free(frame);
    return result;
}

/* What the technique says of a picture; of others that were drawn before nothing may be left in its
 * way. */
static GpResult tell(const TechniqueStage *stage, const char *options, const Frame *frame,
                     GpError *error)
{
    const Technique *technique = stage->technique;
    TechniqueReport report = { .members = json_object() };
    void *setting = NULL;
    GpResult result = technique_setting(technique, options, &setting, error);
    if (!result && technique->report)
        result = technique->report(stage->scene, setting, frame, stage->device, &report, error);
    gp_free(setting);
    text_free(&report.lines);
    text_free(&report.warnings);
    json_decref(report.members);
    return result;
}

uint64_t technique_stage_hash(const TechniqueStage *stage, const char *options)
{
    GpError error = { "" };
    Frame frame;
    if (technique_stage_draw(stage, options, &frame, &error) ||
        tell(stage, options, &frame, &error))
        fail_msg("%s: %s", options, error.text);
    const uint64_t hash = hash_targets(&frame.list);
    frame_free(&frame);
    return hash;
}

GpResult technique_stage_measure(const TechniqueStage *stage, const char *options,
                                 TechniqueError *measured, GpError *error)
{
    Frame frame;
    GpResult result = technique_stage_draw(stage, options, &frame, error);
    if (result)
        return result;
    result = stage->technique->experiments->measure(stage->scene, &frame, measured, error);
    frame_free(&frame);
    return result;
}

double technique_metric(const Technique *technique, const TechniqueError *measured,
                        const char *name)
{
    if (strcmp(name, "error") == 0)
        return measured->error;
    const char *const *metrics = technique->experiments->metrics;
    for (int i = 0; metrics[i]; i++)
        if (strcmp(name, metrics[i]) == 0)
            return measured->metrics[i];
    return (double)NAN;
}

/* --- tables ----------------------------------------------------------------------------------- */

static GpResult check_case(const TechniqueStage *stage, const TechniqueCase *row, GpError *error)
{
    TechniqueError measured;
    GpError reason = { "" };
    GpResult result = technique_stage_measure(stage, row->options, &measured, &reason);
    if (result)
        return gp_fail(error, result, "%s: %s: %s", row->name, row->options, reason.text);
    double metric = technique_metric(stage->technique, &measured, row->metric);
    if (metric >= row->low && metric <= row->high)
        return GP_OK;
    return gp_fail(error, GP_ERROR_INVALID, "%s: %s: %s is %g, not in [%g, %g]", row->name,
                   row->options, row->metric, metric, row->low, row->high);
}

GpResult technique_cases_check(const Technique *technique, const TechniqueCase *cases, size_t count,
                               GpError *error)
{
    TechniqueStage stage = { .scene = NULL };
    GpResult first = GP_OK, opened = GP_OK;
    GpError reason = { "" };
    for (size_t i = 0; i < count; i++) {
        if (i == 0 || strcmp(cases[i].scene, cases[i - 1].scene) != 0) {
            technique_stage_close(&stage);
            opened = technique_stage_open(technique, cases[i].scene, 0, 0, &stage, &reason);
        }
        const GpResult result = opened ? opened : check_case(&stage, &cases[i], &reason);
        if (!result)
            continue;
        print_message("# row %zu: %s\n", i, reason.text);
        if (!first)
            gp_fail(error, result, "%s", reason.text);
        first = first ? first : result;
    }
    technique_stage_close(&stage);
    return first;
}
