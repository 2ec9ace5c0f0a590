#include "apps/commands/technique_command.h"

#include "apps/charts/chart.h"
#include "apps/commands/commands.h"
#include "apps/base/json.h"
#include "apps/commands/output.h"
#include "apps/frame/picture.h"

#include <stdio.h>
#include <string.h>

enum { KEY_ERROR = 0x200, KEY_CURVE, OWN_OPTIONS = 3 };

typedef struct TechniqueArgs {
    Options options; /* first: see options.h */
    const Technique *technique;
    const TechniqueResult *result; /* NULL: a picture */
    void *setting;
    const char *scene, *output, *curve;
    bool is_set; /* a member of the setting was given */
    bool has_error;
    double error;
} TechniqueArgs;

/* --- options ---------------------------------------------------------------------------------- */

/* clang-format off */
static const struct argp_option own_options[OWN_OPTIONS + 1] = {
    { "output", 'o', "FILE", 0, NULL, 0 },
    { "error", KEY_ERROR, "E", 0, "Take the cheapest setting of a stored chart whose error is at "
      "most E, and say which", 0 },
    { "curve", KEY_CURVE, "FILE", 0, "The chart for --error: JSON as `glasspipe chart' writes it "
      "(default: the technique's in out/charts, or in charts)", 0 },
    { NULL, 0, NULL, 0, NULL, 0 },
};
/* clang-format on */

static const char picture_output_help[] =
    "Write the picture to FILE: .png, .exr, .pfm or .ppm (default: out/NAME.png where out/ exists, "
    "else NAME.png)";

/* The name of the setting that an option sets, or NULL. */
static const char *member_of_key(const TechniqueArgs *args, int key)
{
    const SettingField *field = setting_of_key(args->technique->fields, key);
    if (key == 'n' && args->result)
        return args->result->count_field;
    return field ? field->name : NULL;
}

static error_t set_member(struct argp_state *state, TechniqueArgs *args, int key, char *text)
{
    const char *member = member_of_key(args, key);
    GpError error = { "" };
    if (!member)
        return args->result ? args->result->parse(key, text, state, args->result->own)
                            : ARGP_ERR_UNKNOWN;
    if (setting_set(args->technique->fields, args->setting, member, text, &error))
        argp_error(state, "%s", error.text);
    args->is_set = true;
    return 0;
}

static error_t parse_technique(int key, char *text, struct argp_state *state)
{
    TechniqueArgs *args = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        return options_start(state);
    case 'o':
        args->output = text;
        return 0;
    case KEY_ERROR:
        args->error = options_real(state, "--error", text);
        args->has_error = true;
        return 0;
    case KEY_CURVE:
        args->curve = text;
        return 0;
    case ARGP_KEY_ARG:
        return options_positional(state, &args->scene, 1, text);
    case ARGP_KEY_END:
        if (!args->scene)
            argp_error(state, "expected %s", args->result ? args->result->input : "a scene file");
        if (args->has_error && args->is_set)
            argp_error(state, "--error chooses the setting: no option of it can be given too");
        if (args->curve && !args->has_error)
            argp_error(state, "--curve is for --error");
        return 0;
    default:
        return set_member(state, args, key, text);
    }
}

/* Those of the fields, of all techniques, and of the result. */
static void list_options(const TechniqueArgs *args, struct argp_option *options)
{
    const TechniqueResult *result = args->result;
    setting_options(args->technique->fields, options);
    struct argp_option *end = options;
    for (; end->name; end++)
        if (result && strcmp(end->name, result->count_field) == 0)
            end->key = 'n';
    memcpy(end, own_options, sizeof own_options);
    end->doc = result ? result->output_help : picture_output_help;
    end += OWN_OPTIONS;
    for (int i = 0; result && result->options[i].name; i++) {
        GP_ASSERT(i < TECHNIQUE_MAX_OPTIONS);
        *end++ = result->options[i];
    }
    *end = (struct argp_option){ .name = NULL };
}

static void parse(const TechniqueHelp *help, int argc, char **argv, TechniqueArgs *args)
{
    const struct argp_child children[] = {
        { help->result ? &options_run : &options_frame, 0, NULL, 0 },
        { NULL, 0, NULL, 0 },
    };
    struct argp_option options[SETTING_MAX_FIELDS + OWN_OPTIONS + TECHNIQUE_MAX_OPTIONS + 1];
    list_options(args, options);
    const struct argp parser = { options,    parse_technique, help->arguments,
                                 help->text, children,        options_help,
                                 NULL };
    options_parse(&parser, argc, argv, args);
}

/* --- a setting from a stored chart -------------------------------------------------------------- */

static void default_curve(const Technique *technique, char *path, size_t size)
{
    snprintf(path, size, "%s/%s.json", chart_folder(), technique->name);
}

/* Says which setting was chosen, and why. */
static void explain_choice(const TechniqueArgs *args, const Chart *chart, const ChartPoint *point)
{
    uint32_t enough = 0;
    for (uint32_t i = 0; i < chart->count; i++)
        enough += chart->points[i].measured.error <= args->error;
    notice(&args->options,
           "chose %s (%s): %g %s, in %.2f ms, the fastest of %u settings of %u with at most %g",
           point->options, point->method, point->measured.error, chart->error_name, point->ms,
           enough, chart->count, args->error);
    char scene[320];
    chart_print_scene(chart, scene, sizeof scene);
    notice(&args->options, "measured on %s, %d thread%s, %s", scene, chart->threads,
           chart->threads == 1 ? "" : "s", chart->machine);
}

/* Of this technique, or of another with the same settings: that of solids for voxelize. */
static bool is_of(const Chart *chart, const Technique *technique)
{
    const Technique *other = technique_find(chart->technique);
    return other && other->fields == technique->fields;
}

static int choose(TechniqueArgs *args)
{
    char path[CHART_MAX_PATH];
    GpError error = { "" };
    Chart chart = { .points = NULL };
    default_curve(args->technique, path, sizeof path);
    const char *curve = args->curve ? args->curve : path;
    GpResult result = chart_read(curve, &chart, &error);
    if (result) {
        report(0, "%s", error.text);
        return report(exit_of_input(result), "--error needs a chart: `glasspipe chart %s' makes it",
                      args->technique->name);
    }
    const ChartPoint *point = chart_choose(&chart, args->error);
    int code = EXIT_DONE;
    if (!is_of(&chart, args->technique))
        code = report(EXIT_INPUT, "%s: a chart of %s", curve, chart.technique);
    else if (!point)
        code = report(EXIT_INPUT, "%s: no setting has at most %g %s", curve, args->error,
                      chart.error_name);
    else if (setting_parse(args->technique->fields, args->setting, point->options, &error))
        code = report(EXIT_INPUT, "%s: %s", curve, error.text);
    else
        explain_choice(args, &chart, point);
    chart_free(&chart);
    return code;
}

/* --- the frame -------------------------------------------------------------------------------- */

static int draw_picture(const TechniqueRun *run)
{
    const Technique *technique = run->technique;
    GpError error = { "" };
    Frame frame = { .color = NULL };
    if (technique->build(run->scene, run->setting, &frame, &error))
        return report(EXIT_INPUT, "%s: %s", run->input, error.text);
    char setting[SETTING_MAX_TEXT];
    setting_print(technique->fields, run->setting, technique->defaults, setting, sizeof setting);
    json_t *more = json_pack("{s:s}", "setting", setting);
    int code = output_frame(run->options, run->input, run->output, run->device, &frame.list,
                            frame.color, true, more);
    json_decref(more);
    frame_free(&frame);
    return code;
}

static GpResult check_output(const TechniqueArgs *args, const char *output, GpError *error)
{
    const TechniqueResult *result = args->result;
    GpError reason;
    if (result)
        return result->check(output, args->setting, result->own, error);
    return picture_check_path(output, &reason)
               ? gp_fail(error, GP_ERROR_INVALID, "-o %s", reason.text)
               : GP_OK;
}

static int open_and_draw(const TechniqueArgs *args, TechniqueRun *run)
{
    const Technique *technique = args->technique;
    GpError error = { "" };
    GpResult result = technique->open(args->scene, args->options.width, args->options.height,
                                      &run->scene, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    int code = args->result ? args->result->run(run) : draw_picture(run);
    technique->close(run->scene);
    return code;
}

static int run(TechniqueArgs *args)
{
    GpError error = { "" };
    char path[4096];
    output_default_path(args->scene, args->result ? args->result->extension : "png", path,
                        sizeof path);
    TechniqueRun run = { .options = &args->options,
                         .technique = args->technique,
                         .input = args->scene,
                         .output = args->output ? args->output : path,
                         .setting = args->setting,
                         .own = args->result ? args->result->own : NULL };
    if (check_output(args, run.output, &error))
        return report(EXIT_USAGE, "%s", error.text);
    int code = args->has_error ? choose(args) : EXIT_DONE;
    if (code)
        return code;
    code = options_device(&args->options, NULL, &run.device);
    if (code)
        return code;
    code = open_and_draw(args, &run);
    gp_device_destroy(&run.device);
    return code;
}

int technique_command(const Technique *technique, const TechniqueHelp *help, int argc, char **argv)
{
    TechniqueArgs args = { .technique = technique, .result = help->result };
    args.setting = gp_alloc(1, technique->setting_bytes);
    if (!args.setting)
        return report(EXIT_INTERNAL, "out of memory");
    memcpy(args.setting, technique->defaults, technique->setting_bytes);
    parse(help, argc, argv, &args);
    int code = run(&args);
    gp_free(args.setting);
    return code;
}
