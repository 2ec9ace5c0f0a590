#include "apps/bench_tables.h"

#include "apps/commands.h"
#include "apps/study_shadow.h"
#include "apps/timing.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST_FRAMES = 20 };

/* The thesis does not give its scenes away: these are ours, of about the same kind. */
#define SCENE_1 "scenes/shadow_bunny.json"
#define SCENE_2 "scenes/shadow.json"

#define THESIS_SHADOWS "thesis, chapter 4; GeForce 5950, Pentium 4 at 2.8 GHz"
#define AS_PRINTED     " --fit light --facing smooth --outside printed"

static const BenchTableRow rows_4_1[] = {
    { "scene 1", SCENE_1, { 160, 220 } },
    { "scene 2", SCENE_2, { 125, 176 } },
    { .name = NULL },
};

static const BenchTableRow rows_4_2[] = {
    { "scene 1", SCENE_1, { 110, 217 } },
    { "scene 2", SCENE_2, { 85, 173 } },
    { .name = NULL },
};

const BenchTable bench_tables[] = {
    { "4.1",
      "efficiency of the two shadow mapping methods",
      THESIS_SHADOWS,
      &shadow_technique,
      { "plain", "hardware" },
      { "--method plain --filter nearest --bias 0.002" AS_PRINTED,
        "--method hardware --filter nearest --bias 0.002 --slope 0" AS_PRINTED },
      rows_4_1 },
    { "4.2",
      "the same, both with bilinear filtering",
      THESIS_SHADOWS,
      &shadow_technique,
      { "plain", "hardware" },
      { "--method plain --filter bilinear --bias 0.002" AS_PRINTED,
        "--method hardware --filter bilinear --bias 0.002 --slope 0" AS_PRINTED },
      rows_4_2 },
    { .id = NULL },
};

const BenchTable *bench_table_find(const char *id)
{
    for (const BenchTable *table = bench_tables; table->id; table++)
        if (strcmp(table->id, id) == 0)
            return table;
    return NULL;
}

/* --- measuring -------------------------------------------------------------------------------- */

typedef struct Job {
    const BenchTable *table;
    const Options *options;
    double seconds; /* for each setting */
    GpDevice *device;
    double *each;
} Job;

/* Milliseconds of a frame of a setting; 0 after a message. */
static double measure_setting(const Job *job, void *scene, int column)
{
    const TimingPlan plan = { job->seconds, LEAST_FRAMES, 2 * job->seconds };
    const char *options = job->table->options[column];
    GpError error = { "" };
    Work work = { .color = NULL };
    Frame frame;
    Timing timing = { .ms = 0 };
    GpResult result = technique_build(job->table->technique, scene, options, &work, &error);
    if (!result)
        result = frame_first(job->device, &work.list, &frame, &error);
    if (!result)
        result = timing_run(job->device, &work.list, &plan, job->each, &frame, &timing, &error);
    if (result)
        report(EXIT_INPUT, "%s: %s", options, error.text);
    work_free(&work);
    return timing.ms;
}

static void print_row(const Job *job, const BenchTableRow *row, const double *ms)
{
    if (job->options->json) {
        json_t *object = json_pack("{s:s, s:s, s:s}", "table", job->table->id, "row", row->name,
                                   "scene", row->scene);
        for (int i = 0; i < TABLE_COLUMNS; i++)
            json_object_set_new(
                object, job->table->columns[i],
                json_pack("{s:f, s:f}", "printed", row->printed[i], "measured", 1e3 / ms[i]));
        json_dumpf(object, stdout, JSON_COMPACT | JSON_REAL_PRECISION(6));
        putchar('\n');
        json_decref(object);
        return;
    }
    printf("%-10s", row->name);
    for (int i = 0; i < TABLE_COLUMNS; i++)
        printf("  %9.0f %9.1f", row->printed[i], 1e3 / ms[i]);
    printf("  %6.2f %6.2f  %s\n", row->printed[1] / row->printed[0], ms[0] / ms[1], row->scene);
}

static int run_row(const Job *job, const BenchTableRow *row)
{
    const Technique *technique = job->table->technique;
    GpError error = { "" };
    void *scene = NULL;
    double ms[TABLE_COLUMNS];
    GpResult result = technique->open(row->scene, 0, 0, &scene, &error);
    if (result == GP_ERROR_FORMAT || result == GP_ERROR_IO) {
        notice(job->options, "%s: skipped: %s", row->name, error.text);
        return EXIT_DONE;
    }
    if (result)
        return report(EXIT_INTERNAL, "%s", error.text);
    bool measured = true;
    for (int i = 0; measured && i < TABLE_COLUMNS; i++) {
        ms[i] = measure_setting(job, scene, i);
        measured = ms[i] > 0;
    }
    technique->close(scene);
    if (measured)
        print_row(job, row, ms);
    return measured ? EXIT_DONE : EXIT_INPUT;
}

static void print_head(const BenchTable *table)
{
    printf("Table %s: %s (%s)\n", table->id, table->title, table->source);
    printf("frames a second, printed and here; last: %s over %s, printed and here\n",
           table->columns[1], table->columns[0]);
    printf("%-10s", "");
    for (int i = 0; i < TABLE_COLUMNS; i++)
        printf("  %19s", table->columns[i]);
    putchar('\n');
}

int bench_table_run(const BenchTable *table, const Options *options, double seconds)
{
    Job job = { .table = table, .options = options, .seconds = seconds };
    int code = options_device(options, NULL, &job.device);
    if (code)
        return code;
    job.each = gp_alloc(TIMING_MAX_FRAMES, sizeof *job.each);
    if (!job.each)
        exit(report(EXIT_INTERNAL, "out of memory"));
    if (!options->json)
        print_head(table);
    for (const BenchTableRow *row = table->rows; !code && row->name; row++)
        code = run_row(&job, row);
    gp_free(job.each);
    gp_device_destroy(&job.device);
    return code;
}
