/* glasspipe chart: speed against accuracy of a technique's settings. */
#include "apps/commands/chart/chart.h"

#include "apps/base/folder.h"
#include "apps/base/text.h"
#include "apps/charts/chart_file.h"
#include "apps/charts/chart_page.h"
#include "apps/charts/chart_run.h"
#include "apps/charts/scaling_file.h"
#include "apps/charts/scaling_run.h"
#include "apps/commands/chart/chart_sweep.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/commands/progress.h"

#include <stdio.h>
#include <string.h>
#include <xxhash.h>

enum { CHART_MAX_NAME = 64 };

typedef struct ChartCommand {
    Options options; /* first: see options.h */
    const Technique *const *techniques;
    const char *name; /* of an experiment, or of a technique with --scaling */
    const char *scene, *folder, *own_name;
    ChartSweep *sweep;
    double seconds;
    bool scaling;
} ChartCommand;

static const SettingField options[] = {
    { "output", "DIR",
      "Write to the folder DIR, made where it does not exist "
      "(default: out/charts where out/ exists, else charts)",
      SETTING_TEXT, .offset = offsetof(ChartCommand, folder), .letter = 'o' },
    { "name", "NAME",
      "Call the files NAME.svg and so on (default: the technique's name, with the scene's where "
      "that is not its own, and _own where settings are given)",
      SETTING_TEXT, .offset = offsetof(ChartCommand, own_name) },
    { "time", "SECONDS", "Draw each setting for so long (default: 0.3)", SETTING_NUMBER,
      .offset = offsetof(ChartCommand, seconds), .high = OPTIONS_ANY, .letter = 't' },
    { "scaling", NULL,
      "Instead of accuracy, chart how time grows with what the technique is asked for: "
      "sizes and scenes of its own",
      SETTING_FLAG, .offset = offsetof(ChartCommand, scaling) },
    OPTIONS_ITEMS,
    { .name = NULL },
};

/* "voxelize, solids, shadow" */
static void list_experiments(const Technique *const *techniques, char *list, size_t size)
{
    size_t used = 0;
    for (snprintf(list, size, "none"); *techniques; techniques++)
        for (const Experiment *one = (*techniques)->experiments; one->name && used < size; one++)
            used += (size_t)snprintf(list + used, size - used, "%s%s", used ? ", " : "", one->name);
}

static void check(struct argp_state *state, void *args)
{
    const ChartCommand *command = args;
    char list[256];
    list_experiments(command->techniques, list, sizeof list);
    if (!command->name)
        argp_error(state, "expected a technique (there are: %s)", list);
    else if (!experiment_find(command->techniques, command->name, NULL))
        argp_error(state, "no technique '%s' (there are: %s)", command->name, list);
    if (command->own_name && (!command->own_name[0] || strchr(command->own_name, '/')))
        argp_error(state, "--name: expected a name without '/', not '%s'", command->own_name);
    if (command->own_name && strlen(command->own_name) >= CHART_MAX_NAME)
        argp_error(state, "--name: expected at most %d bytes, not '%s'", CHART_MAX_NAME - 1,
                   command->own_name);
    if (!command->scaling) {
        chart_sweep_check(state, command->sweep);
        if (command->sweep->rows && strcmp(command->sweep->experiment->name, command->name) != 0)
            argp_error(state, "settings are those of %s: name %s first",
                       command->sweep->experiment->name, command->name);
        return;
    }
    const Technique *technique = technique_find(command->techniques, command->name);
    if (!technique || !technique->scaling)
        argp_error(state, "--scaling: %s has no table of what grows", command->name);
    if (command->own_name || command->sweep->options.given)
        argp_error(state, "--scaling has names and settings of its own");
    if (command->scene || command->options.size[0])
        argp_error(state, "--scaling draws scenes and sizes of its own");
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_FRAME,
    .options = options,
    .arguments = "TECHNIQUE [SCENE.json]",
    .help =
        "Examples:\n"
        "  glasspipe chart shadow\n"
        "  glasspipe chart shadow scenes/shadow_avenue.json --size 512x320 -t 0.1\n"
        "  glasspipe chart shadow -o charts --threads 2\n"
        "  glasspipe chart shadow --map 512,1024 --method plain,hardware \\\n"
        "      --name maps\n"
        "  glasspipe chart voxelize --scaling\n"
        "\n"
        "Draws a scene with every setting of a technique's sweep, measures time and distance "
        "from the exact result, and writes a chart as SVG, CSV and JSON, and a page of all "
        "charts.\v"
        "A technique's settings are options here too, and each takes a list: then these are swept, "
        "in all combinations (glasspipe chart shadow --help lists them). Without a scene, the "
        "technique's own is drawn. Printed are the best settings: nothing "
        "else measured is both faster and more exact.",
    .offset = offsetof(ChartCommand, name),
    .most = 2,
    .check = check,
};

/* --- messages --------------------------------------------------------------------------------- */

static void tell_notice(const void *user, const char *line)
{
    notice(((const Progress *)user)->options, "%s", line);
}

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
    for (uint32_t i = 0; i < count; i++) {
        char error[32];
        text_for_people(best[i]->measured.error, 6, error);
        printf("%10.3f  %*s  %s: %s\n", best[i]->time.ms, width, error, best[i]->method,
               best[i]->options);
    }
    gp_free(best);
    return EXIT_DONE;
}

static void print_scaling(const Scaling *scaling)
{
    printf("%10s  %12s  setting\n", "ms", "amount");
    for (uint32_t i = 0; i < scaling->count; i++) {
        const ScalingPoint *point = &scaling->points[i];
        printf("%10.3f  %12.10g  %s: %s %s\n", point->time.ms, point->amount,
               scaling_name(scaling, point), point->scene, point->options);
    }
}

/* --- writing ---------------------------------------------------------------------------------- */

/* Writes one of the two, and the page, and says so. returns an exit code, after a message if it is
 * not EXIT_DONE */
static int write_all(const ChartCommand *command, const char *name, const Chart *chart,
                     const Scaling *scaling)
{
    char path[CHART_MAX_PATH];
    GpError error = { "" };
    if (snprintf(path, sizeof path, "%s/%s", command->folder, name) >= (int)sizeof path)
        return report(EXIT_INTERNAL, "%.200s: the path is too long", command->folder);
    GpResult result =
        chart ? chart_write(path, chart, &error) : scaling_write(path, scaling, &error);
    if (result || chart_write_page(command->folder, command->techniques, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(&command->options, "wrote %s.svg, .csv%s and %s/index.html", path,
           chart ? ", .json" : "", command->folder);
    return EXIT_DONE;
}

/* How settings are drawn. A journal is of this experiment on this scene, measured so long and
 * so. */
static ItemRun items_of(const ChartCommand *command, const ChartJob *job,
                        const ChartListener *listener)
{
    ItemRun run = options_items(&command->options);
    const TechniqueSweep *sweep = job->experiment->sweep;
    Text text = { .data = NULL };
    text_add(&text, "%s %s %s %ux%u %.17g %d %s %d", GP_VERSION, job->experiment->name, job->scene,
             job->width, job->height, job->seconds, gp_device_threads(job->device),
             gp_device_isa(job->device), (int)command->options.executor);
    for (size_t i = 0; sweep[i].method; i++)
        text_add(&text, "; %s", sweep[i].options);
    run.key = XXH3_64bits(text.data ? text.data : "", text.length);
    run.resume = run.resume && !text.failed; /* the key would be another's */
    text_free(&text);
    run.journal = "glasspipe-chart.journal";
    run.progress = listener->progress;
    run.user = listener->user;
    return run;
}

static int chart_accuracy(const ChartCommand *command, GpDevice *device,
                          const ChartListener *listener)
{
    ChartJob job = { .width = command->options.size[0],
                     .height = command->options.size[1],
                     .folder = command->folder,
                     .seconds = command->seconds,
                     .device = device,
                     .listener = *listener };
    job.experiment = experiment_find(command->techniques, command->name, &job.technique);
    if (command->sweep->rows)
        job.experiment = &command->sweep->own;
    job.scene = command->scene ? command->scene : job.experiment->scene;
    char name[CHART_MAX_NAME];
    Chart chart = { .points = NULL };
    GpError error = { "" };
    chart_name(job.experiment, job.scene, name, sizeof name);
    if (command->sweep->rows)
        snprintf(name + strlen(name), sizeof name - strlen(name), "_own");
    if (command->own_name)
        text_copy(name, sizeof name, command->own_name);
    job.name = name;
    const ItemRun run = items_of(command, &job, listener);
    job.run = &run;
    bool is_unwritten = false;
    job.is_unwritten = &is_unwritten;
    GpResult result = chart_run(&job, &chart, &error);
    int code = result ? report(is_unwritten ? EXIT_INTERNAL : exit_of_run(result), "%s", error.text)
                      : write_all(command, name, &chart, NULL);
    if (!code)
        code = command->options.json ? output_json(chart_json(&chart)) : print_best(&chart);
    chart_free(&chart);
    return code;
}

static int chart_scaling(const ChartCommand *command, GpDevice *device,
                         const ChartListener *listener)
{
    char name[CHART_MAX_NAME];
    Scaling scaling = { .points = NULL };
    GpError error = { "" };
    snprintf(name, sizeof name, "%s_scaling", command->name);
    GpResult result = scaling_run(technique_find(command->techniques, command->name), device,
                                  listener, command->seconds, &scaling, &error);
    int code = result ? report(exit_of_run(result), "%s", error.text)
                      : write_all(command, name, NULL, &scaling);
    if (!code && command->options.json)
        code = output_json(scaling_json(&scaling));
    else if (!code)
        print_scaling(&scaling);
    scaling_free(&scaling);
    return code;
}

static int run_command(const ChartCommand *command)
{
    const Progress progress = progress_begin(&command->options);
    const ChartListener listener = { tell_notice, progress_tell, &progress };
    GpDevice *device;
    int code = options_device(&command->options, NULL, &device);
    if (code)
        return code;
    GpError error = { "" };
    if (folder_make(command->folder, &error))
        code = report(EXIT_INTERNAL, "%s", error.text);
    else
        code = (command->scaling ? chart_scaling : chart_accuracy)(command, device, &listener);
    gp_device_destroy(&device);
    return code;
}

int chart_command(const Technique *const *techniques, int argc, char **argv)
{
    ChartSweep sweep;
    ChartCommand command = {
        .techniques = techniques, .seconds = 0.3, .folder = chart_folder(), .sweep = &sweep
    };
    CommandSyntax own = syntax;
    chart_sweep_prepare(techniques, argc, argv, &sweep);
    if (sweep.technique && setting_find(sweep.technique->settings, "size"))
        own.shared = OPTIONS_RUN; /* --size is the technique's */
    command_parse(&own, &sweep.options, argc, argv, &command);
    const int code = run_command(&command);
    chart_sweep_free(&sweep);
    return code;
}

int cmd_chart(int argc, char **argv)
{
    return chart_command(technique_registry, argc, argv);
}
