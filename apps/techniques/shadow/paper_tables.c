/* Tables 4.1 and 4.2: frames a second of shadow mapping in two forms. */
#include "apps/commands/paper_tables.h"
#include "apps/commands/commands.h"
#include "apps/techniques/shadow/technique.h"

#include <stdio.h>

enum { COLUMNS = 2 };

typedef struct FramesRow {
    const char *name, *scene; /* as printed; what is drawn here: a path */
    double printed[COLUMNS];
} FramesRow;

typedef struct Frames {
    const char *options[COLUMNS];
    const FramesRow *rows; /* name NULL ends them */
} Frames;

static const char *const columns[COLUMNS] = { "plain", "hardware" };

/* The thesis does not give its scenes away: these are ours, of about the same kind. */
#define SCENE_1 "scenes/shadow_bunny.json"
#define SCENE_2 "scenes/shadow.json"

#define THESIS_SHADOWS "thesis, chapter 4; GeForce 5950, Pentium 4 at 2.8 GHz"
#define AS_PRINTED     " --fit light --facing smooth --outside printed"

static const FramesRow rows_4_1[] = {
    { "scene 1", SCENE_1, { 160, 220 } },
    { "scene 2", SCENE_2, { 125, 176 } },
    { .name = NULL },
};

static const FramesRow rows_4_2[] = {
    { "scene 1", SCENE_1, { 110, 217 } },
    { "scene 2", SCENE_2, { 85, 173 } },
    { .name = NULL },
};

static const Frames frames_4_1 = {
    { "--method plain --filter nearest --bias 0.002" AS_PRINTED,
      "--method hardware --filter nearest --bias 0.002 --slope 0" AS_PRINTED },
    rows_4_1,
};

static const Frames frames_4_2 = {
    { "--method plain --filter bilinear --bias 0.002" AS_PRINTED,
      "--method hardware --filter bilinear --bias 0.002 --slope 0" AS_PRINTED },
    rows_4_2,
};

static void print_row(const BenchTable *table, const BenchTableRun *run, const FramesRow *row,
                      const double *ms)
{
    if (run->options->json) {
        json_t *object =
            json_pack("{s:s, s:s, s:s}", "table", table->id, "row", row->name, "scene", row->scene);
        for (int i = 0; i < COLUMNS; i++)
            json_object_set_new(object, columns[i], bench_table_pair(row->printed[i], 1e3 / ms[i]));
        bench_table_print(object);
        return;
    }
    printf("%-10s", row->name);
    for (int i = 0; i < COLUMNS; i++)
        printf("  %9.0f %9.1f", row->printed[i], 1e3 / ms[i]);
    printf("  %6.2f %6.2f  %s\n", row->printed[1] / row->printed[0], ms[0] / ms[1], row->scene);
}

static int run_row(const BenchTable *table, const BenchTableRun *run, const FramesRow *row)
{
    const Frames *frames = table->content;
    void *scene;
    double ms[COLUMNS];
    int code = bench_table_open(run, &shadow_technique, row->name, row->scene, &scene);
    if (!scene)
        return code;
    for (int i = 0; !code && i < COLUMNS; i++) {
        Frame frame = { .color = NULL };
        RunStatistics statistics;
        Timing timing = { .ms = 0 };
        GpError error = { "" };
        if (technique_time(&run->clock, &shadow_technique, scene, frames->options[i], &frame,
                           &statistics, &timing, &error))
            code = report(EXIT_INPUT, "%s: %s", frames->options[i], error.text);
        frame_free(&frame);
        ms[i] = timing.ms;
    }
    shadow_technique.close(scene);
    if (!code)
        print_row(table, run, row, ms);
    return code;
}

static int run_frames(const BenchTable *table, const BenchTableRun *run)
{
    if (!run->options->json) {
        printf("frames a second, printed and here; last: %s over %s, printed and here\n",
               columns[1], columns[0]);
        printf("%-10s", "");
        for (int i = 0; i < COLUMNS; i++)
            printf("  %19s", columns[i]);
        putchar('\n');
    }
    int code = EXIT_DONE;
    const Frames *frames = table->content;
    for (const FramesRow *row = frames->rows; !code && row->name; row++)
        code = run_row(table, run, row);
    return code;
}

const BenchTable bench_table_4_1 = {
    .id = "4.1",
    .title = "efficiency of the two shadow mapping methods",
    .source = THESIS_SHADOWS,
    .run = run_frames,
    .content = &frames_4_1,
};

const BenchTable bench_table_4_2 = {
    .id = "4.2",
    .title = "the same, both with bilinear filtering",
    .source = THESIS_SHADOWS,
    .run = run_frames,
    .content = &frames_4_2,
};
