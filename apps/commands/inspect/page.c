#include "apps/commands/inspect/page.h"

#include "apps/base/json.h"
#include "apps/commands/cache_file.h"
#include "apps/commands/output.h"
#include "apps/commands/progress.h"
#include "apps/inspect/inspect.h"
#include "pipeline/list/list.h"

/* --- what is drawn ---------------------------------------------------------------------------- */

void inspect_release(const InspectCommand *command, Drawn *drawn)
{
    gp_free(drawn->off);
    frame_free(&drawn->frame);
    if (drawn->opened)
        command->technique->close(drawn->opened);
    scene_free(&drawn->scene);
}

static GpResult build(const InspectCommand *command, const void *setting, GpDevice *device,
                      Drawn *drawn, GpError *error)
{
    const Technique *technique = command->technique;
    GpResult result = technique->build(drawn->opened, setting, device, &drawn->frame, error);
    if (!result && technique->show)
        result = technique->show(drawn->opened, setting, &drawn->frame, error);
    drawn->list = &drawn->frame.list;
    drawn->picture = frame_picture(&drawn->frame);
    return result;
}

static const Experiment *experiment_of(const Technique *technique)
{
    for (const Experiment *one = technique->experiments; one && one->name; one++)
        if (one->find_truth && one->difference)
            return one;
    return NULL;
}

/* Holds a frame of its own against the truth, since passes may be appended to it. */
static GpResult find_off(const InspectCommand *command, const void *setting, GpDevice *device,
                         Drawn *drawn, GpError *error)
{
    const Technique *technique = command->technique;
    const Experiment *experiment = experiment_of(technique);
    Frame frame = { .color = NULL };
    if (!experiment)
        return gp_fail(error, GP_ERROR_INVALID, "--truth: %s does not know the exact picture",
                       technique->name);
    GpResult result = experiment->find_truth(drawn->opened, gp_device_threads(device), error);
    if (!result)
        result = technique->build(drawn->opened, setting, device, &frame, error);
    if (!result && technique->show)
        result = technique->show(drawn->opened, setting, &frame, error);
    if (!result)
        result = gp_device_run(device, &frame.list, error);
    const GpSurface *picture = result ? NULL : frame_picture(&frame);
    float *off = picture ? gp_alloc((size_t)picture->width * picture->height, sizeof *off) : NULL;
    if (picture && !off)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for a picture's truth");
    if (!result)
        result = experiment->difference(drawn->opened, setting, device, &frame, off, error);
    frame_free(&frame);
    if (result) {
        gp_free(off);
        return result;
    }
    drawn->off = off;
    drawn->experiment = experiment;
    return GP_OK;
}

static int open_technique(const InspectCommand *command, const char *path, void *setting,
                          Drawn *drawn)
{
    GpError error = { "" };
    GpDevice *device = NULL;
    const Technique *technique = command->technique;
    const Progress progress = progress_begin(&command->options);
    const TechniqueInput input = { .path = path,
                                   .width = command->options.size[0],
                                   .height = command->options.size[1],
                                   .setting = setting,
                                   .progress = progress_tell,
                                   .user = &progress };
    if (technique->imply)
        technique->imply(setting, command->settings.given);
    if (technique->check && technique->check(setting, command->settings.given, "png", &error))
        return report(EXIT_USAGE, "%s", error.text);
    if (cache_file_check(technique->settings, setting, &error))
        return report(EXIT_USAGE, "%s", error.text);
    int code = options_device(&command->options, NULL, &device);
    if (code)
        return code;
    GpResult result = technique->open(&input, &drawn->opened, &error);
    if (result) {
        gp_device_destroy(&device);
        return report(exit_of_input(result), "%s", error.text); /* it names the file */
    }
    result = build(command, setting, device, drawn, &error);
    if (!result && command->truth)
        result = find_off(command, setting, device, drawn, &error);
    else if (!result && technique->quick_truth) /* a scene without one is shown without it */
        find_off(command, setting, device, drawn, &(GpError){ "" });
    gp_device_destroy(&device);
    return result ? report(exit_of_input(result), "%s: %s", path, error.text) : EXIT_DONE;
}

static int open_scene(const InspectCommand *command, const char *path, Drawn *drawn)
{
    if (command->truth)
        return report(EXIT_USAGE, "--truth: exact pictures are a technique's; see --technique");
    const int code = options_scene(&command->options, path, &drawn->scene);
    drawn->list = &drawn->scene.list;
    drawn->picture = drawn->scene.picture;
    return code;
}

/* The region is of any pass, the draw of the last. */
static int check_choice(const InspectCommand *command, const GpList *list)
{
    const double *region = command->region;
    const uint32_t draws = list->pass_count ? list->passes[list->pass_count - 1].draw_count : 0;
    bool is_inside = region[2] == 0;
    for (uint32_t p = 0; p < list->pass_count && !is_inside; p++) {
        uint32_t width, height;
        gp_pass_size(&list->passes[p], &width, &height);
        is_inside = region[0] < width && region[1] < height;
    }
    if (!is_inside)
        return report(EXIT_USAGE, "--region %g %g %g %g: no pass draws there", region[0], region[1],
                      region[2], region[3]);
    if (command->draw != UINT32_MAX && command->draw >= draws)
        return report(EXIT_USAGE, "--draw %u: the last pass has %u draw%s", command->draw, draws,
                      draws == 1 ? "" : "s");
    return EXIT_DONE;
}

int inspect_open(const InspectCommand *command, const char *path, void *setting, Drawn *drawn)
{
    const int code = command->technique ? open_technique(command, path, setting, drawn)
                                        : open_scene(command, path, drawn);
    return code ? code : check_choice(command, drawn->list);
}

/* --- the page --------------------------------------------------------------------------------- */

static Inspect inspect_of(const InspectCommand *command, const Drawn *drawn, const char *title,
                          const Progress *progress)
{
    const double *region = command->region;
    const Lesson *lesson = command->lesson;
    return (Inspect){
        .title = title,
        .technique = command->technique ? command->technique->name : NULL,
        .list = drawn->list,
        .picture = drawn->picture,
        .truth = drawn->off ? (InspectTruth){ drawn->off, drawn->experiment->over,
                                              drawn->experiment->under, drawn->experiment->truth }
                            : (InspectTruth){ .off = NULL },
        .region =
            lesson && region[2] == 0
                ? (GpRect){ lesson->x, lesson->y, lesson->x + 1, lesson->y + 1 }
                : (GpRect){ (int32_t)region[0], (int32_t)region[1],
                            (int32_t)(region[0] + region[2]), (int32_t)(region[1] + region[3]) },
        .lesson = lesson,
        .draw = command->draw == UINT32_MAX ? -1 : (int32_t)command->draw,
        .pixels = command->pixels,
        .no_timings = command->no_timings,
        .threads = (int)command->options.threads,
        .isa = command->options.isa,
        .progress = progress_tell,
        .user = progress,
    };
}

int inspect_write(const InspectCommand *command, const char *path, const Drawn *drawn,
                  const Drawn *other)
{
    GpError error = { "" };
    Text page;
    char name[128], other_name[128];
    text_stem(command->scene, name, sizeof name);
    text_stem(command->against ? command->against : "", other_name, sizeof other_name);
    const Progress progress = progress_begin(&command->options);
    const Inspect inspect = inspect_of(command, drawn, name, &progress);
    const bool is_setting = command->against && command->against[0] == '-';
    const Inspect against =
        inspect_of(command, other, is_setting ? command->against : other_name, &progress);
    GpResult result = inspect_page(&inspect, command->against ? &against : NULL, &page, &error);
    if (result)
        return report(exit_of_run(result), "%s: %s", command->scene, error.text);
    const size_t bytes = page.length;
    result = text_write(path, &page, &error);
    text_free(&page);
    if (result)
        return report(EXIT_INTERNAL, "%s", error.text);
    if (command->options.json)
        return output_json(
            json_pack("{s:o, s:I}", "page", json_text(path), "bytes", (json_int_t)bytes));
    notice(&command->options, "%s: %.1f MB", path, (double)bytes / 1e6);
    return EXIT_DONE;
}
