#include "apps/commands/technique_command.h"

#include "apps/commands/cache_file.h"
#include "apps/commands/output.h"
#include "apps/commands/progress.h"
#include "apps/commands/technique_choice.h"
#include "apps/frame/picture.h"
#include "pipeline/io/file.h"

#include <stdio.h>
#include <string.h>

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

static void check(struct argp_state *state, void *object)
{
    technique_check_error(state, object);
}

/* Those of the settings, and of all techniques. */
static void parse(int argc, char **argv, TechniqueArgs *args)
{
    const Technique *technique = args->technique;
    char alpha[64], alpha_help[160];
    snprintf(alpha, sizeof alpha, "output-%s", technique->alpha ? technique->alpha : "");
    snprintf(alpha_help, sizeof alpha_help,
             "Write the %s alone to FILE, as a grey picture: .png, .exr, .pfm or .ppm",
             technique->alpha ? technique->alpha : "");
    const SettingField options[] = {
        { "output", "FILE",
          !technique->volume ? picture_help
          : technique->show  ? volume_or_picture_help
                             : volume_help,
          SETTING_TEXT, .offset = offsetof(TechniqueArgs, output), .letter = 'o' },
        { "error", "E",
          "Take the cheapest setting whose error, measured on this scene, is at most E, and say "
          "which; 0.05% is a share. A stored chart says where to begin",
          SETTING_TEXT, .offset = offsetof(TechniqueArgs, error) },
        { "trust-chart", NULL, "Believe the chart, which is of another scene, and measure nothing",
          SETTING_FLAG, .offset = offsetof(TechniqueArgs, trusts_chart) },
        { "curve", "FILE",
          "The chart for --error: JSON as `glasspipe chart' writes it (default: the "
          "technique's in out/charts, or in charts)",
          SETTING_TEXT, .offset = offsetof(TechniqueArgs, curve) },
        { technique->alpha ? alpha : NULL, "FILE", alpha_help, SETTING_TEXT,
          .offset = offsetof(TechniqueArgs, alpha) },
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
    if (args->alpha && picture_check_path(args->alpha, &reason))
        return gp_fail(error, GP_ERROR_INVALID, "--output-%s %s", technique->alpha, reason.text);
    for (const SettingField *field = technique->settings; field->name; field++)
        if (field->for_pictures && !picture &&
            setting_is_given(technique->settings, args->settings.given, field->name))
            return gp_fail(error, GP_ERROR_INVALID, "--%s is for pictures: -o FILE.png",
                           field->name);
    if (technique->imply)
        technique->imply(args->settings.object, args->settings.given);
    if (technique->check)
        result =
            technique->check(args->settings.object, args->settings.given, args->extension, error);
    return result ? result : cache_file_check(technique->settings, args->settings.object, error);
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

/* The setting as it was used: every value, with those that were chosen. errors GP_ERROR_MEMORY */
static GpResult tell_setting(const TechniqueArgs *args, const void *scene, json_t *members,
                             GpError *error)
{
    const Technique *technique = args->technique;
    SettingText text;
    void *used = gp_alloc(1, technique->setting_bytes);
    if (!used)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    memcpy(used, args->settings.object, technique->setting_bytes);
    if (technique->resolve)
        technique->resolve(scene, used);
    setting_print(technique->settings, used, NULL, text, sizeof text);
    json_object_set_new(members, "setting", json_string(text));
    gp_free(used);
    return GP_OK;
}

/* What the technique has to say. owns: the caller, until free_report. errors as its report's */
static GpResult tell(const TechniqueArgs *args, void *scene, const Frame *frame, GpDevice *device,
                     TechniqueReport *told, GpError *error)
{
    const Technique *technique = args->technique;
    if (args->options.json) {
        told->members = json_object();
        GpResult failed = tell_setting(args, scene, told->members, error);
        if (failed)
            return failed;
    }
    GpResult result = technique->report ? technique->report(scene, args->settings.object, frame,
                                                            device, told, error)
                                        : GP_OK;
    if (!result && (told->lines.failed || told->warnings.failed))
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
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

/* Whether alpha goes into the picture's file: EXR, whose readers do not blend by it unasked. */
static bool carries_alpha(const TechniqueArgs *args, const void *scene)
{
    const Technique *technique = args->technique;
    return technique->alpha && strcmp(args->extension, "exr") == 0 &&
           !(technique->check_alpha && technique->check_alpha(scene, NULL));
}

/* The first frame is what is written and told. in chosen: for --json; NULL: none */
static int draw(const TechniqueArgs *args, void *scene, GpDevice *device, const Frame *frame,
                json_t *chosen)
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
                      .alpha_path = args->alpha,
                      .alpha_name = technique->alpha,
                      .opaque = !carries_alpha(args, scene) };
    GpResult result = run_first(device, &frame->list, &output.statistics, &error);
    if (result)
        return report(exit_of_run(result), "%s: %s", args->scene, error.text);
    if (technique->volume && !picture_has_extension(args->output))
        result = technique->volume(frame, &output.volume, &error);
    if (!result)
        result = tell(args, scene, frame, device, &told, &error);
    if (chosen && told.members)
        json_object_set(told.members, "error", chosen);
    output.lines = told.lines.data;
    output.members = told.members;
    output.rate = technique->rate;
    int code = result ? report(exit_of_input(result), "%s: %s", args->scene, error.text)
                      : output_result(&output);
    free_report(&told);
    gp_volume_free(&output.volume);
    return code;
}

static int draw_opened(TechniqueArgs *args, void *scene, GpDevice *device)
{
    GpError error = { "" };
    Frame frame = { .color = NULL };
    json_t *chosen = NULL;
    const int choice = args->error ? technique_choose(args, scene, device, &chosen) : EXIT_DONE;
    int code = choice;
    if (!choice || choice == EXIT_DIFFERS) {
        GpResult result = build(args, scene, device, &frame, &error);
        code = result ? report(exit_of_input(result), "%s: %s", args->scene, error.text)
                      : draw(args, scene, device, &frame, chosen);
    }
    frame_free(&frame);
    json_decref(chosen);
    return code ? code : choice;
}

static int open_and_draw(TechniqueArgs *args, GpDevice *device)
{
    const Progress progress = progress_begin(&args->options);
    TechniqueInput input = technique_input(args);
    GpError error = { "" };
    void *scene;
    input.progress = progress_tell;
    input.user = &progress;
    GpResult result = args->technique->open(&input, &scene, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    if (args->alpha && args->technique->check_alpha)
        result = args->technique->check_alpha(scene, &error);
    const int code = result ? report(EXIT_INPUT, "%s: %s", args->scene, error.text)
                            : draw_opened(args, scene, device);
    args->technique->close(scene);
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
    int code = options_device(&args->options, NULL, &device);
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
                           .settings = { .fields = technique->settings, .object = setting } };
    parse(argc, argv, &args);
    int code = run(&args);
    gp_free(setting);
    return code;
}
