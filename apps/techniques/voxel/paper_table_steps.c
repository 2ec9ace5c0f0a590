/* Table 2.1: the steps of voxelization for models of different size. */
#include "apps/commands/paper_tables.h"
#include "apps/techniques/voxel/sheets_time.h"
#include "apps/commands/commands.h"

#include <stdio.h>

enum { SIZE = 256, STEPS = 4 };

/* For the settings; SIZE as text. */
#define AT_SIZE " --size 256"

typedef struct StepsRow {
    const char *name, *mesh; /* NULL: not at hand */
    bool reduced;            /* has fewer triangles than the one that was printed */
    uint32_t triangles;      /* printed */
    double printed[STEPS];
} StepsRow;

static const char *const step_names[STEPS] = { "raster", "texelize", "synthesize", "sort" };

static const StepsRow rows[] = {
    { "Duck", NULL, false, 1254, { 9, 8, 10, 0.8 } },
    { "Hugo", NULL, false, 16928, { 9.7, 8.3, 10, 7 } },
    { "Bunny", "meshes/bunny.ply", false, 69451, { 12, 8, 11, 27 } },
    { "Dragon", "meshes/dragon_res2.ply", true, 871326, { 38, 8, 11, 330 } },
    { "Buddha", "meshes/happy_buddha.ply", false, 1087514, { 47, 7.8, 10, 415 } },
    { "Blade", "meshes/blade_199k.ply", true, 1765388, { 75, 8, 12, 660 } },
};

/* What a row comes to here, in milliseconds. */
typedef struct StepsMeasured {
    double step[STEPS];
    double sheets, conservative, thin; /* whole frames */
    uint32_t triangles;
    uint64_t voxels; /* of sheets */
    double worksheets_mb;
} StepsMeasured;

/* --- measuring -------------------------------------------------------------------------------- */

static GpResult measure_whole(const TechniqueClock *clock, VoxelScene *scene, const char *options,
                              double *ms, GpError *error)
{
    Frame frame = { .color = NULL };
    RunStatistics statistics;
    Timing timing;
    GpResult result = technique_time(clock, &voxel_technique, scene, options, &frame, &statistics,
                                     &timing, error);
    frame_free(&frame);
    if (!result)
        *ms = timing.ms;
    return result;
}

static GpResult measure_sheets(const TechniqueClock *clock, VoxelScene *scene,
                               StepsMeasured *measured, GpError *error)
{
    Frame frame = { .color = NULL };
    RunStatistics statistics;
    Timing timing;
    SheetsTimes steps;
    GpResult result = technique_time(clock, &voxel_technique, scene, "--method sheets" AT_SIZE,
                                     &frame, &statistics, &timing, error);
    if (result)
        return result;
    const VoxelMade *made = frame.made;
    measured->sheets = timing.ms;
    measured->voxels = flat_texture_count(&made->sheet);
    measured->worksheets_mb = (double)sheets_bytes(&frame.list) / (1 << 20);
    result = sheets_time_steps(clock, &frame, &steps, error);
    frame_free(&frame);
    if (result)
        return result;
    measured->step[0] = steps.raster;
    measured->step[1] = steps.texelize;
    measured->step[2] = steps.synthesize;
    return sheets_time_sort(clock, scene, SIZE, &measured->step[3], error);
}

static GpResult measure_row(const TechniqueClock *clock, VoxelScene *scene, StepsMeasured *measured,
                            GpError *error)
{
    measured->triangles = scene->mesh.triangle_count;
    GpResult result = measure_sheets(clock, scene, measured, error);
    if (!result)
        result = measure_whole(clock, scene, "--method conservative" AT_SIZE,
                               &measured->conservative, error);
    if (!result)
        result = measure_whole(clock, scene, "--method thin" AT_SIZE, &measured->thin, error);
    return result;
}

/* --- printing --------------------------------------------------------------------------------- */

static void print_json(const BenchTable *table, const StepsRow *row, const StepsMeasured *measured)
{
    json_t *object = json_pack("{s:s, s:s, s:s, s:b, s:o}", "table", table->id, "row", row->name,
                               "scene", row->mesh, "reduced", row->reduced, "triangles",
                               json_pack("{s:I, s:I}", "printed", (json_int_t)row->triangles,
                                         "measured", (json_int_t)measured->triangles));
    for (int i = 0; i < STEPS; i++)
        json_object_set_new(object, step_names[i],
                            bench_table_pair(row->printed[i], measured->step[i]));
    json_t *own = json_pack("{s:f, s:f, s:f, s:I, s:f}", "sheets", measured->sheets, "conservative",
                            measured->conservative, "thin", measured->thin, "voxels",
                            (json_int_t)measured->voxels, "worksheets_mb", measured->worksheets_mb);
    json_object_update(object, own);
    json_decref(own);
    bench_table_print(object);
}

static void print_text(const StepsRow *row, const StepsMeasured *measured)
{
    printf("%-8s  %8u %8u ", row->name, row->triangles, measured->triangles);
    for (int i = 0; i < STEPS; i++)
        printf("  %5g %7.2f", row->printed[i], measured->step[i]);
    printf("  %7.2f %7.2f %7.2f  %7llu %5.1f  %s%s\n", measured->sheets, measured->conservative,
           measured->thin, (unsigned long long)measured->voxels, measured->worksheets_mb, row->mesh,
           row->reduced ? " (reduced)" : "");
}

/* As printed, where there is nothing to measure. */
static void print_missing(const StepsRow *row)
{
    printf("%-8s  %8u %8s ", row->name, row->triangles, "");
    for (int i = 0; i < STEPS; i++)
        printf("  %5g %7s", row->printed[i], "");
    printf("  %40s(not at hand)\n", "");
}

static void print_head(void)
{
    printf("milliseconds at %d voxels a side, printed and here; then whole methods, and of the "
           "first its voxels and the megabytes that it draws into\n",
           SIZE);
    printf("%-8s  %17s ", "", "triangles");
    for (int i = 0; i < STEPS; i++)
        printf("  %13s", step_names[i]);
    printf("  %7s %7s %7s  %7s %5s\n", "sheets", "conserv", "thin", "voxels", "MB");
}

/* --- the table -------------------------------------------------------------------------------- */

static int run_row(const BenchTable *table, const BenchTableRun *run, const StepsRow *row)
{
    void *scene;
    StepsMeasured measured;
    GpError error = { "" };
    int code = bench_table_open(run, &voxel_technique, row->name, row->mesh, &scene);
    if (!scene)
        return code;
    if (measure_row(&run->clock, scene, &measured, &error))
        code = report(EXIT_INPUT, "%s: %s", row->name, error.text);
    else if (run->options->json)
        print_json(table, row, &measured);
    else
        print_text(row, &measured);
    voxel_technique.close(scene);
    return code;
}

static int run_steps(const BenchTable *table, const BenchTableRun *run)
{
    int code = EXIT_DONE;
    if (!run->options->json)
        print_head();
    for (size_t i = 0; i < GP_COUNT(rows) && !code; i++) {
        if (rows[i].mesh)
            code = run_row(table, run, &rows[i]);
        else if (!run->options->json)
            print_missing(&rows[i]);
    }
    return code;
}

const BenchTable bench_table_2_1 = {
    .id = "2.1",
    .title = "efficiency of surface voxelization",
    .source = "thesis, chapter 2",
    .run = run_steps,
};
