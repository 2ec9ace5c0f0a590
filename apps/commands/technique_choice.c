#include "apps/commands/technique_choice.h"

#include "apps/base/json.h"
#include "apps/base/machine.h"
#include "apps/charts/chart_file.h"
#include "apps/charts/promise.h"
#include "apps/commands/progress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* --- what was asked for ----------------------------------------------------------------------- */

/* "300" or "0.05%". */
static bool read_error(TechniqueArgs *args)
{
    const char *text = args->error;
    char *end;
    args->most = strtod(text, &end);
    const bool is_number = end > text;
    args->per_cent = *end == '%';
    end += args->per_cent;
    return is_number && *end == '\0' && text[strspn(text, "0123456789.eE+-%")] == '\0' &&
           args->most >= 0 && args->most <= OPTIONS_ANY;
}

/* Whether an experiment is meant by options of the key: "--kind" of "--kind solid". */
static bool means(const Experiment *experiment, const SettingField *field)
{
    char option[64];
    snprintf(option, sizeof option, "--%s ", field->name);
    return experiment->given && strstr(experiment->given, option);
}

/* The experiment of the given options; none where one of them is of the key and means none. */
static const Experiment *meant_experiment(const TechniqueArgs *args)
{
    const Technique *technique = args->technique;
    const SettingField *fields = technique->settings;
    SettingText given;
    for (int i = 0; fields[i].name; i++) {
        bool is_good = fields[i].aside || !(args->settings.given >> i & 1);
        for (const Experiment *one = technique->experiments; one->name; one++)
            is_good |= means(one, &fields[i]);
        if (!is_good)
            return NULL;
    }
    setting_print(fields, args->settings.object, technique->defaults, given, sizeof given);
    for (const Experiment *one = technique->experiments; one->name; one++)
        if (strcmp(one->given ? one->given : "", given) == 0)
            return one;
    return NULL;
}

void technique_check_error(struct argp_state *state, TechniqueArgs *args)
{
    args->most = -1;
    if (!args->error && args->curve)
        argp_error(state, "--curve is for --error");
    if (!args->error && args->trusts_chart)
        argp_error(state, "--trust-chart is for --error");
    if (!args->error)
        return;
    if (!read_error(args))
        argp_error(state,
                   "--error: expected a number from 0, or one with %% behind it, such as 0.05%%, "
                   "not '%s'",
                   args->error);
    args->experiment = meant_experiment(args);
    if (!args->experiment)
        argp_error(state, "--error chooses the setting: no option of it can be given too");
    if (args->per_cent && !args->experiment->part_of)
        argp_error(state, "--error: %s are no part of anything, so that there are no %% of them",
                   args->experiment->error_name);
}

/* --- the chart -------------------------------------------------------------------------------- */

/* Where charts are looked for, and measurements kept beside them. */
typedef struct Place {
    char curve[CHART_MAX_PATH], measured[CHART_MAX_PATH];
} Place;

static Place find_place(const TechniqueArgs *args)
{
    Place place;
    snprintf(place.curve, sizeof place.curve, "%s/%s.json", chart_folder(), args->experiment->name);
    if (args->curve)
        snprintf(place.curve, sizeof place.curve, "%s", args->curve);
    const char *slash = strrchr(place.curve, '/');
    snprintf(place.measured, sizeof place.measured, "%.*smeasured",
             slash ? (int)(slash - place.curve + 1) : 0, place.curve);
    return place;
}

/* Of one of its experiments, or NULL. */
static const Experiment *experiment_of(const Technique *technique, const char *name)
{
    for (const Experiment *experiment = technique->experiments; experiment->name; experiment++)
        if (strcmp(experiment->name, name) == 0)
            return experiment;
    return NULL;
}

/* Reads the chart where there is one; where one was named it must be there, and says what is
 * meant. */
static int read_chart(TechniqueArgs *args, const Place *place, Chart *chart)
{
    GpError error = { "" };
    const bool is_needed = args->curve || args->trusts_chart;
    if (!is_needed && access(place->curve, F_OK) != 0)
        return EXIT_DONE;
    GpResult result = chart_read(place->curve, chart, &error);
    if (result) {
        report(0, "%s", error.text);
        return report(exit_of_input(result), "`glasspipe chart %s' makes a chart",
                      args->experiment->name);
    }
    const Experiment *own = experiment_of(args->technique, chart->technique);
    if (!own)
        return report(EXIT_INPUT, "%s: a chart of %s", place->curve, chart->technique);
    args->experiment = own;
    return EXIT_DONE;
}

/* --- what is said ----------------------------------------------------------------------------- */

/* "276 (measured)", or in per cent of its whole where it was asked so. */
static void print_error(const TechniqueArgs *args, const TechniqueError *error, const char *how,
                        char *text, size_t size)
{
    const double per_cent = chart_per_cent(error);
    if (args->per_cent)
        snprintf(text, size, "%.4g%% (%s), %.6g %s", per_cent, how, error->error,
                 args->experiment->error_name);
    else
        snprintf(text, size, "%.6g (%s) %s", error->error, how, args->experiment->error_name);
    const size_t used = strlen(text);
    if (!args->per_cent && args->experiment->part_of && !isnan(per_cent))
        snprintf(text + used, size - used, ", %.3g%% of %s", per_cent, args->experiment->part_of);
}

static json_t *tell(const TechniqueArgs *args, const Candidate *chosen, const TechniqueError *error,
                    bool is_kept)
{
    return json_pack("{s:s, s:o, s:s, s:o, s:b, s:b}", "method", chosen->method, "most",
                     json_number(args->most), "unit",
                     args->per_cent ? "%" : args->experiment->error_name, "error",
                     json_number(args->per_cent ? chart_per_cent(error) : error->error), "measured",
                     !args->trusts_chart, "reached", is_kept);
}

/* --- choosing --------------------------------------------------------------------------------- */

static int apply(const TechniqueArgs *args, const char *curve, const char *options)
{
    GpError error = { "" };
    if (setting_parse(args->technique->settings, args->settings.object, options, &error))
        return report(EXIT_INPUT, "%s: %s", curve, error.text);
    return EXIT_DONE;
}

/* What the chart says, and nothing else; its most exact setting where none is exact enough. */
static int trust(const TechniqueArgs *args, const char *curve, const Chart *chart, json_t **told)
{
    Candidates all = { .first = 0 };
    GpError error = { "" };
    char what[256], scene[320];
    const ChartPoint *point = NULL;
    if (candidates_list(args->experiment, chart, args->most, args->per_cent, &all, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    for (uint32_t i = 0; i < chart->count && !point; i++)
        if (strcmp(chart->points[i].options, all.list[all.first].options) == 0)
            point = &chart->points[i];
    const Candidate chosen = all.list[all.first];
    gp_free(all.list);
    const double least = !point           ? (double)NAN
                         : args->per_cent ? chart_per_cent(&point->measured)
                                          : point->measured.error;
    const bool is_reached = least <= args->most;
    if (!point)
        return report(EXIT_INPUT, "%s: no setting is in it", curve);
    print_error(args, &point->measured, "expected, from another scene", what, sizeof what);
    chart_print_scene(chart, scene, sizeof scene);
    if (is_reached)
        notice(&args->options, "chose %s (%s): error %s", chosen.options, chosen.method, what);
    else
        report(0, "not reached: the most exact of %s, %s (%s), has error %s", curve, chosen.options,
               chosen.method, what);
    notice(&args->options, "measured on %s, %d thread%s, %s", scene, chart->threads,
           chart->threads == 1 ? "" : "s", chart->machine);
    if (args->options.json)
        *told = tell(args, &chosen, &point->measured, is_reached);
    const int code = apply(args, curve, point->options);
    return code || is_reached ? code : EXIT_DIFFERS;
}

static int keep(const TechniqueArgs *args, const Place *place, const Chart *chart, void *scene,
                GpDevice *device, json_t **told)
{
    const Progress progress = progress_begin(&args->options);
    const PromiseJob job = { .technique = args->technique,
                             .experiment = args->experiment,
                             .chart = chart->points ? chart : NULL,
                             .scene = scene,
                             .setting = args->settings.object,
                             .given = args->settings.given,
                             .extension = args->extension,
                             .device = device,
                             .most = args->most,
                             .per_cent = args->per_cent,
                             .listener = { .progress = progress_tell, .user = &progress } };
    const TechniqueInput input = technique_input(args);
    Measured measured;
    Promise promise;
    GpError error = { "" }, unwritten = { "" };
    measured_open(place->measured, args->experiment->name,
                  measured_key(args->technique, args->experiment, &input), &measured);
    GpResult result = promise_choose(&job, &measured, &promise, &error);
    if (measured_write(&measured, &unwritten))
        notice(&args->options, "not remembered: %s", unwritten.text);
    measured_close(&measured);
    if (result)
        return report(exit_of_run(result), "%s: %s", args->scene, error.text);
    char what[256];
    print_error(args, &promise.measured, "measured", what, sizeof what);
    if (!promise.is_kept)
        report(0, "not reached: the most exact of all %u settings, %s (%s), has error %s",
               promise.tried, promise.chosen.options, promise.chosen.method, what);
    else
        notice(&args->options, "chose %s (%s): error %s", promise.chosen.options,
               promise.chosen.method, what);
    char ruled_out[64] = "";
    if (promise.ruled_out > 0)
        snprintf(ruled_out, sizeof ruled_out, ", %u ruled out undrawn", promise.ruled_out);
    notice(&args->options, "looked at %u setting%s, %u of them remembered%s, in %.2f s",
           promise.tried, promise.tried == 1 ? "" : "s",
           promise.tried - promise.drawn - promise.ruled_out, ruled_out,
           (machine_clock_ms(CLOCK_MONOTONIC) - progress.start_ms) / 1e3);
    if (args->options.json)
        *told = tell(args, &promise.chosen, &promise.measured, promise.is_kept);
    const int code = apply(args, place->curve, promise.chosen.options);
    return code || promise.is_kept ? code : EXIT_DIFFERS;
}

int technique_choose(TechniqueArgs *args, void *scene, GpDevice *device, json_t **told)
{
    const Place place = find_place(args);
    Chart chart = { .points = NULL };
    int code = read_chart(args, &place, &chart);
    if (!code)
        code = args->trusts_chart ? trust(args, place.curve, &chart, told)
                                  : keep(args, &place, &chart, scene, device, told);
    chart_free(&chart);
    return code;
}
