#include "apps/commands/technique_command.h"

#include "apps/charts/chart_file.h"
#include "apps/commands/command.h"
#include "apps/commands/output.h"
#include "apps/frame/picture.h"
#include "pipeline/io/file.h"

#include <stdio.h>
#include <string.h>

typedef struct TechniqueArgs {
    Options options; /* first: see options.h */
    const Technique *technique;
    CommandOptions settings;
    const char *scene, *output, *curve;
    char extension[8]; /* of the output */
    double error;      /* --error; negative: not given */
} TechniqueArgs;

/* --- options ---------------------------------------------------------------------------------- */

static const char picture_help[] =
    "Write the picture to FILE: .png, .exr, .pfm or .ppm (default: out/NAME.png where out/ exists, "
    "else NAME.png)";
static const char volume_help[] =
    "Write the volume to FILE: .nrrd, or .bits, one bit a voxel and nothing else (default: "
    "out/NAME.nrrd where out/ exists, else NAME.nrrd)";
static const char volume_or_picture_help[] =
    "Write the volume to FILE: .nrrd, or .bits, one bit a voxel and nothing else (default: "
    "out/NAME.nrrd where out/ exists, else NAME.nrrd); or a picture of it: .png, .exr, .pfm or "
    ".ppm";

/* Whether the user gave a part of the key. */
static bool has_key(const TechniqueArgs *args)
{
    const SettingField *fields = args->technique->settings;
    for (int i = 0; fields[i].name; i++)
        if (!fields[i].aside && args->settings.given >> i & 1)
            return true;
    return false;
}

static void check(struct argp_state *state, void *object)
{
    const TechniqueArgs *args = object;
    if (args->error >= 0 && has_key(args))
        argp_error(state, "--error chooses the setting: no option of it can be given too");
    if (args->curve && args->error < 0)
        argp_error(state, "--curve is for --error");
}

/* Those of the settings, and of all techniques. */
static void parse(int argc, char **argv, TechniqueArgs *args)
{
    const Technique *technique = args->technique;
    const SettingField options[] = {
        { "output", "FILE",
          !technique->volume ? picture_help
          : technique->show  ? volume_or_picture_help
                             : volume_help,
          SETTING_TEXT, .offset = offsetof(TechniqueArgs, output), .letter = 'o' },
        { "error", "E",
          "Take the cheapest setting of a stored chart whose error is at most E, and say which",
          SETTING_NUMBER, .offset = offsetof(TechniqueArgs, error), .high = OPTIONS_ANY },
        { "curve", "FILE",
          "The chart for --error: JSON as `glasspipe chart' writes it (default: the "
          "technique's in out/charts, or in charts)",
          SETTING_TEXT, .offset = offsetof(TechniqueArgs, curve) },
        { .name = NULL },
    };
    const CommandSyntax syntax = {
        .shared = setting_find(technique->settings, "size") ? OPTIONS_RUN : OPTIONS_FRAME,
        .options = options,
        .arguments = technique->arguments,
        .help = technique->help,
        .offset = offsetof(TechniqueArgs, scene),
        .least = 1,
        .most = 1,
        .expected = technique->input,
        .check = check,
    };
    command_parse(&syntax, &args->settings, argc, argv, args);
}

/* --- the output ------------------------------------------------------------------------------- */

static GpResult check_volume(const TechniqueArgs *args, GpError *error)
{
    if (strcmp(args->extension, "nrrd") != 0 && strcmp(args->extension, "bits") != 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: expected a name that ends with .nrrd or .bits%s", args->output,
                       args->technique->show ? ", or that of a picture, .png, .exr, .pfm or .ppm"
                                             : "");
    if (gp_path_is_folder(args->output))
        return gp_fail(error, GP_ERROR_INVALID, "%s: is a directory", args->output);
    return GP_OK;
}

/* Whether the output could be written, as far as its name tells, and the settings go with it. */
static GpResult check_output(TechniqueArgs *args, GpError *error)
{
    const Technique *technique = args->technique;
    GpError reason;
    gp_file_extension(args->output, args->extension);
    const bool picture =
        picture_has_extension(args->output) && (technique->show || !technique->volume);
    GpResult result = picture || !technique->volume ? picture_check_path(args->output, &reason)
                                                    : check_volume(args, &reason);
    if (result)
        return gp_fail(error, result, "-o %s", reason.text);
    for (const SettingField *field = technique->settings; field->name; field++)
        if (field->for_pictures && !picture &&
            setting_is_given(technique->settings, args->settings.given, field->name))
            return gp_fail(error, GP_ERROR_INVALID, "--%s is for pictures: -o FILE.png",
                           field->name);
    return technique->check ? technique->check(args->settings.object, args->settings.given,
                                               args->extension, error)
                            : GP_OK;
}

/* --- a setting from a stored chart -------------------------------------------------------------- */

/* Says which setting was chosen, and why. */
static void explain_choice(const TechniqueArgs *args, const Chart *chart, const ChartPoint *point)
{
    uint32_t enough = 0;
    for (uint32_t i = 0; i < chart->count; i++)
        enough += chart->points[i].measured.error <= args->error;
    notice(&args->options,
           "chose %s (%s): %g %s, in %.2f ms, the fastest of %u settings of %u with at most %g",
           point->options, point->method, point->measured.error, chart->error_name, point->time.ms,
           enough, chart->count, args->error);
    char scene[320];
    chart_print_scene(chart, scene, sizeof scene);
    notice(&args->options, "measured on %s, %d thread%s, %s", scene, chart->threads,
           chart->threads == 1 ? "" : "s", chart->machine);
}

/* Of one of its experiments. */
static bool is_of(const Chart *chart, const Technique *technique)
{
    for (const Experiment *experiment = technique->experiments; experiment->name; experiment++)
        if (strcmp(experiment->name, chart->technique) == 0)
            return true;
    return false;
}

static int choose(TechniqueArgs *args)
{
    const Technique *technique = args->technique;
    char path[CHART_MAX_PATH];
    GpError error = { "" };
    Chart chart = { .points = NULL };
    snprintf(path, sizeof path, "%s/%s.json", chart_folder(), technique->name);
    const char *curve = args->curve ? args->curve : path;
    GpResult result = chart_read(curve, &chart, &error);
    if (result) {
        report(0, "%s", error.text);
        return report(exit_of_input(result), "--error needs a chart: `glasspipe chart %s' makes it",
                      technique->name);
    }
    const ChartPoint *point = chart_choose(&chart, args->error);
    int code = EXIT_DONE;
    if (!is_of(&chart, technique))
        code = report(EXIT_INPUT, "%s: a chart of %s", curve, chart.technique);
    else if (!point)
        code = report(EXIT_INPUT, "%s: no setting has at most %g %s", curve, args->error,
                      chart.error_name);
    else if (setting_parse(technique->settings, args->settings.object, point->options, &error))
        code = report(EXIT_INPUT, "%s: %s", curve, error.text);
    else
        explain_choice(args, &chart, point);
    chart_free(&chart);
    return code;
}

/* --- the frame -------------------------------------------------------------------------------- */

static GpResult build(const TechniqueArgs *args, void *scene, GpDevice *device, Frame *frame,
                      GpError *error)
{
    const Technique *technique = args->technique;
    GpResult result = technique->build(scene, args->settings.object, device, frame, error);
    if (!result && technique->show && picture_has_extension(args->output))
        result = technique->show(scene, args->settings.object, frame, error);
    return result;
}

/* What the technique has to say. owns: the caller, until free_report. errors as its report's */
static GpResult tell(const TechniqueArgs *args, void *scene, const Frame *frame, GpDevice *device,
                     TechniqueReport *told, GpError *error)
{
    const Technique *technique = args->technique;
    char setting[SETTING_MAX_TEXT];
    if (args->options.json) {
        setting_print(technique->settings, args->settings.object, technique->defaults, setting,
                      sizeof setting);
        told->members = json_pack("{s:s}", "setting", setting);
    }
    GpResult result = technique->report ? technique->report(scene, args->settings.object, frame,
                                                            device, told, error)
                                        : GP_OK;
    const char *line = told->warnings.data && !result ? told->warnings.data : "";
    while (*line) {
        const size_t length = strcspn(line, "\n");
        report(0, "warning: %.*s", (int)length, line);
        line += length + (line[length] == '\n');
    }
    return result;
}

static void free_report(TechniqueReport *told)
{
    text_free(&told->lines);
    text_free(&told->warnings);
    json_decref(told->members);
}

/* The first frame is what is written and told. */
static int draw(const TechniqueArgs *args, void *scene, GpDevice *device, const Frame *frame)
{
    const Technique *technique = args->technique;
    GpError error = { "" };
    TechniqueReport told = { .members = NULL };
    Output output = { .options = &args->options,
                      .input = args->scene,
                      .path = args->output,
                      .device = device,
                      .list = &frame->list,
                      .surface = frame_picture(frame),
                      .opaque = true };
    GpResult result = run_first(device, &frame->list, &output.statistics, &error);
    if (result)
        return report(exit_of_run(result), "%s: %s", args->scene, error.text);
    if (technique->volume && !picture_has_extension(args->output))
        result = technique->volume(frame, &output.volume, &error);
    if (!result)
        result = tell(args, scene, frame, device, &told, &error);
    output.lines = told.lines.data;
    output.members = told.members;
    int code = result ? report(exit_of_input(result), "%s: %s", args->scene, error.text)
                      : output_result(&output);
    free_report(&told);
    gp_volume_free(&output.volume);
    return code;
}

static int open_and_draw(const TechniqueArgs *args, GpDevice *device)
{
    const Technique *technique = args->technique;
    const TechniqueInput input = { args->scene, args->options.size[0], args->options.size[1],
                                   args->settings.object };
    GpError error = { "" };
    Frame frame = { .color = NULL };
    void *scene;
    GpResult result = technique->open(&input, &scene, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    result = build(args, scene, device, &frame, &error);
    int code = result ? report(exit_of_input(result), "%s: %s", args->scene, error.text)
                      : draw(args, scene, device, &frame);
    frame_free(&frame);
    technique->close(scene);
    return code;
}

static int run(TechniqueArgs *args)
{
    GpDevice *device;
    GpError error = { "" };
    char path[4096];
    output_default_path(args->scene, args->technique->volume ? "nrrd" : "png", path, sizeof path);
    args->output = args->output ? args->output : path;
    if (check_output(args, &error))
        return report(EXIT_USAGE, "%s", error.text);
    int code = args->error >= 0 ? choose(args) : EXIT_DONE;
    if (!code)
        code = options_device(&args->options, NULL, &device);
    if (code)
        return code;
    code = open_and_draw(args, device);
    gp_device_destroy(&device);
    return code;
}

int technique_command(const Technique *technique, int argc, char **argv)
{
    void *setting = gp_alloc(1, technique->setting_bytes);
    if (!setting)
        return report(EXIT_INTERNAL, "out of memory");
    memcpy(setting, technique->defaults, technique->setting_bytes);
    TechniqueArgs args = { .technique = technique,
                           .settings = { .fields = technique->settings, .object = setting },
                           .error = -1 };
    parse(argc, argv, &args);
    int code = run(&args);
    gp_free(setting);
    return code;
}
