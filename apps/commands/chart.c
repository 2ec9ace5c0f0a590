/* glasspipe chart: speed against accuracy of a technique's settings. */
#include "apps/charts/chart_run.h"
#include "apps/commands/commands.h"
#include "apps/charts/scaling.h"
#include "apps/base/json.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

typedef struct ChartCommand {
    Options options; /* first: see options.h */
    const char *technique, *scene, *folder;
    double seconds;
    bool scaling;
} ChartCommand;

enum { KEY_SCALING = 0x200 };

/* clang-format off */
static const struct argp_option own_options[] = {
    { "output", 'o', "DIR", 0, "Write to the folder DIR, made where it does not exist "
      "(default: out/charts where out/ exists, else charts)", 0 },
    { "time", 't', "SECONDS", 0, "Draw each setting for so long (default: 0.3)", 0 },
    { "scaling", KEY_SCALING, NULL, 0, "Instead of accuracy, chart how time grows with what the technique "
      "is asked for: sizes and scenes of its own", 0 },
    { NULL, 0, NULL, 0, NULL, 0 },
};
/* clang-format on */

/* "shadow, voxelize" */
static void list_techniques(char *list, size_t size)
{
    size_t used = 0;
    snprintf(list, size, "none");
    for (size_t i = 0; techniques[i] && used < size; i++)
        used +=
            (size_t)snprintf(list + used, size - used, "%s%s", i ? ", " : "", techniques[i]->name);
}

static void check_technique(struct argp_state *state, const ChartCommand *command)
{
    char list[256];
    list_techniques(list, sizeof list);
    if (!command->technique)
        argp_error(state, "expected a technique (there are: %s)", list);
    else if (!technique_find(command->technique))
        argp_error(state, "no technique '%s' (there are: %s)", command->technique, list);
    if (!command->scaling)
        return;
    if (!technique_find(command->technique)->scaling)
        argp_error(state, "--scaling: %s has no table of what grows", command->technique);
    if (command->scene || command->options.width)
        argp_error(state, "--scaling draws scenes and sizes of its own");
}

static error_t parse_chart(int key, char *text, struct argp_state *state)
{
    ChartCommand *command = state->input;
    const char *slots[] = { command->technique, command->scene };
    error_t result;
    switch (key) {
    case ARGP_KEY_INIT:
        return options_start(state);
    case 'o':
        command->folder = text;
        return 0;
    case 't':
        command->seconds = options_real(state, "--time", text);
        return 0;
    case KEY_SCALING:
        command->scaling = true;
        return 0;
    case ARGP_KEY_ARG:
        result = options_positional(state, slots, GP_COUNT(slots), text);
        command->technique = slots[0];
        command->scene = slots[1];
        return result;
    case ARGP_KEY_END:
        check_technique(state, command);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = {
    { &options_frame, 0, NULL, 0 },
    { NULL, 0, NULL, 0 },
};

static const struct argp parser = {
    own_options,
    parse_chart,
    "TECHNIQUE [SCENE.json]",
    "Examples:\n"
    "  glasspipe chart shadow\n"
    "  glasspipe chart shadow scenes/bunny.json --size 512x512 -t 1\n"
    "  glasspipe chart shadow -o /tmp/charts --threads 2\n"
    "  glasspipe chart voxelize --scaling\n"
    "\n"
    "Draws a scene with every setting of a technique's sweep, measures time and distance from the "
    "exact result, and writes a chart as SVG, CSV and JSON, and a page of all charts.\v"
    "Without a scene, the technique's own is drawn. Printed are the best settings: nothing else "
    "measured is both faster and more exact.",
    children,
    options_help,
    NULL,
};

/* --- results ---------------------------------------------------------------------------------- */

static int print_best(const Chart *chart)
{
    const ChartPoint **best = gp_alloc(chart->count, sizeof(const ChartPoint *));
    if (!best)
        return report(EXIT_INTERNAL, "out of memory");
    uint32_t count = chart_list_best(chart, best);
    const int least_width = 14, length = (int)strlen(chart->error_name);
    const int width = length > least_width ? length : least_width;
    printf("%10s  %*s  setting\n", "ms", width, chart->error_name);
    for (uint32_t i = 0; i < count; i++)
        printf("%10.3f  %*.6g  %s: %s\n", best[i]->ms, width, best[i]->measured.error,
               best[i]->method, best[i]->options);
    gp_free(best);
    return EXIT_DONE;
}

/* out  path: FOLDER/NAME. returns an exit code, after a message if it is not EXIT_DONE */
static int make_path(const char *folder, const char *name, char path[CHART_MAX_PATH])
{
    if (snprintf(path, CHART_MAX_PATH, "%s/%s", folder, name) >= CHART_MAX_PATH)
        return report(EXIT_INTERNAL, "%.200s: the path is too long", folder);
    return EXIT_DONE;
}

static int print_object(json_t *object)
{
    if (!object)
        return report(EXIT_INTERNAL, "out of memory");
    json_print(object);
    return EXIT_DONE;
}

/* --- speed against accuracy ------------------------------------------------------------------- */

/* Writes the chart and the page, then reports. */
static int finish(const ChartCommand *command, const ChartJob *job, const Chart *chart)
{
    char name[64], path[CHART_MAX_PATH];
    GpError error = { "" };
    chart_name(job->technique, job->scene, name, sizeof name);
    if (make_path(job->folder, name, path))
        return EXIT_INTERNAL;
    if (chart_write(path, chart, &error) || chart_write_page(job->folder, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(&command->options, "wrote %s.svg, .csv, .json and %s/index.html", path, job->folder);
    return command->options.json ? print_object(chart_json(chart)) : print_best(chart);
}

static int chart_accuracy(const ChartCommand *command, GpDevice *device)
{
    const Technique *technique = technique_find(command->technique);
    const ChartJob job = { .technique = technique,
                           .scene = command->scene ? command->scene : technique->scene,
                           .folder = command->folder,
                           .seconds = command->seconds,
                           .options = &command->options,
                           .device = device };
    Chart chart = { .points = NULL };
    GpError error = { "" };
    GpResult result = chart_run(&job, &chart, &error);
    int code =
        result ? report(exit_of_run(result), "%s", error.text) : finish(command, &job, &chart);
    chart_free(&chart);
    return code;
}

/* --- scaling ----------------------------------------------------------------------------------- */

static void print_scaling(const Scaling *scaling)
{
    printf("%10s  %12s  setting\n", "ms", "amount");
    for (uint32_t i = 0; i < scaling->count; i++) {
        const ScalingPoint *point = &scaling->points[i];
        printf("%10.3f  %12.10g  %s: %s %s\n", point->ms, point->amount,
               scaling_name(scaling, point), point->scene, point->options);
    }
}

static int finish_scaling(const ChartCommand *command, const Scaling *scaling)
{
    char name[64], path[CHART_MAX_PATH];
    GpError error = { "" };
    snprintf(name, sizeof name, "%s_scaling", command->technique);
    if (make_path(command->folder, name, path))
        return EXIT_INTERNAL;
    if (scaling_write(path, scaling, &error) || chart_write_page(command->folder, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(&command->options, "wrote %s.svg, .csv and %s/index.html", path, command->folder);
    if (command->options.json)
        return print_object(scaling_json(scaling));
    print_scaling(scaling);
    return EXIT_DONE;
}

static int chart_scaling(const ChartCommand *command, GpDevice *device)
{
    Scaling scaling = { .points = NULL };
    GpError error = { "" };
    GpResult result = scaling_run(technique_find(command->technique), device, &command->options,
                                  command->seconds, &scaling, &error);
    int code =
        result ? report(exit_of_run(result), "%s", error.text) : finish_scaling(command, &scaling);
    scaling_free(&scaling);
    return code;
}

int cmd_chart(int argc, char **argv)
{
    ChartCommand command = { .seconds = 0.3, .folder = chart_folder() };
    options_parse(&parser, argc, argv, &command);
    GpDevice *device;
    int code = options_device(&command.options, NULL, &device);
    if (code)
        return code;
    if (mkdir(command.folder, 0777) != 0 && errno != EEXIST)
        code = report(EXIT_INTERNAL, "%s: %s", command.folder, strerror(errno));
    else
        code = command.scaling ? chart_scaling(&command, device) : chart_accuracy(&command, device);
    gp_device_destroy(&device);
    return code;
}
