/* Table 2.2: one model in volumes of several sizes and depths, and pictures of them. */
#include "apps/commands/paper_tables.h"
#include "apps/techniques/voxel/sheets_time.h"
#include "apps/commands/commands.h"
#include "apps/techniques/voxel/pictures/view.h"

#include <stdio.h>

enum { PICTURE = 512 }; /* pixels a side; the print does not say */

typedef struct SizesRow {
    uint32_t size, bits;
    double memory_mb, ms, voxels, picture_ms; /* printed */
} SizesRow;

static const SizesRow rows[] = {
    { 512, 1, 16, 500, 620381, 240 },
    { 256, 8, 16, 30, 151347, 10 },
    { 128, 16, 4, 24, 38012, 6 },
    { 64, 8, 0.25, 21, 9379, 4 },
};

/* The print's, Wagner of 60,246 triangles, is not at hand. */
static const char *const meshes[] = { "meshes/bunny.ply", "meshes/happy_buddha.ply" };

typedef struct SizesMeasured {
    double memory_mb, worksheets_mb;
    double ms, picture_ms;
    uint64_t voxels;
} SizesMeasured;

/* --- measuring -------------------------------------------------------------------------------- */

static Camera camera_for(uint32_t size)
{
    const double n = size, middle = n / 2;
    return (Camera){ .eye = { middle + n, middle + 0.8 * n, middle + 2 * n },
                     .at = { middle, middle, middle },
                     .up = { 0, 1, 0 },
                     .fovy = 40,
                     .near = 0.5 * n,
                     .far = 5 * n };
}

static GpResult time_picture(const TechniqueClock *clock, const FlatTexture *sheet, double *ms,
                             GpError *error)
{
    Frame frame = { .color = NULL };
    RunStatistics statistics;
    Timing timing;
    VoxelView view = voxel_view_defaults;
    view.camera = camera_for(sheet->size);
    GpResult result = voxel_view_build(sheet, &view, PICTURE, PICTURE, &frame, error);
    if (!result)
        result = run_first(clock->device, &frame.list, &statistics, error);
    if (!result)
        result = timing_run(clock->device, &frame.list, &clock->plan, clock->each, &statistics,
                            &timing, error);
    frame_free(&frame);
    if (!result)
        *ms = timing.ms;
    return result;
}

/* Pictures are drawn of volumes of one bit. */
static GpResult measure_picture(const TechniqueClock *clock, VoxelScene *scene, uint32_t size,
                                double *ms, GpError *error)
{
    char options[64];
    Frame frame = { .color = NULL };
    RunStatistics statistics;
    snprintf(options, sizeof options, "--method sheets --size %u", size);
    GpResult result = technique_build(&voxel_technique, scene, options, &frame, error);
    if (result)
        return result;
    result = run_first(clock->device, &frame.list, &statistics, error);
    if (!result) {
        const VoxelMade *made = frame.made;
        result = time_picture(clock, &made->sheet, ms, error);
    }
    frame_free(&frame);
    return result;
}

static GpResult measure_row(const TechniqueClock *clock, VoxelScene *scene, const SizesRow *row,
                            SizesMeasured *measured, GpError *error)
{
    char options[64];
    Frame frame = { .color = NULL };
    RunStatistics statistics;
    Timing timing;
    snprintf(options, sizeof options, "--method sheets --size %u --bits %u", row->size, row->bits);
    GpResult result = technique_time(clock, &voxel_technique, scene, options, &frame, &statistics,
                                     &timing, error);
    if (result)
        return result;
    const VoxelMade *made = frame.made;
    measured->ms = timing.ms;
    measured->voxels = flat_texture_count(&made->sheet);
    measured->memory_mb = (double)flat_texture_bytes(&made->sheet) / (1 << 20);
    measured->worksheets_mb = (double)sheets_bytes(&frame.list) / (1 << 20);
    frame_free(&frame);
    return measure_picture(clock, scene, row->size, &measured->picture_ms, error);
}

/* --- printing --------------------------------------------------------------------------------- */

static void print_json(const BenchTable *table, const char *mesh, const SizesRow *row,
                       const SizesMeasured *measured)
{
    bench_table_print(
        json_pack("{s:s, s:s, s:I, s:I, s:o, s:f, s:o, s:o, s:o}", "table", table->id, "scene",
                  mesh, "size", (json_int_t)row->size, "bits", (json_int_t)row->bits, "memory_mb",
                  bench_table_pair(row->memory_mb, measured->memory_mb), "worksheets_mb",
                  measured->worksheets_mb, "ms", bench_table_pair(row->ms, measured->ms), "voxels",
                  bench_table_pair(row->voxels, (double)measured->voxels), "picture_ms",
                  bench_table_pair(row->picture_ms, measured->picture_ms)));
}

static void print_text(const char *mesh, const SizesRow *row, const SizesMeasured *measured)
{
    printf("%4u %4u  %6g %6g %7.1f  %6g %7.2f  %7.0f %7llu  %5g %7.2f  %s\n", row->size, row->bits,
           row->memory_mb, measured->memory_mb, measured->worksheets_mb, row->ms, measured->ms,
           row->voxels, (unsigned long long)measured->voxels, row->picture_ms, measured->picture_ms,
           mesh);
}

static void print_head(void)
{
    printf("printed and here; here in memory also all that is drawn into; pictures of %d x %d are "
           "of one bit a voxel, whatever the row has\n",
           PICTURE, PICTURE);
    printf("%4s %4s  %21s  %14s  %15s  %13s\n", "size", "bits", "megabytes", "milliseconds",
           "voxels", "picture, ms");
}

/* --- the table -------------------------------------------------------------------------------- */

static int run_mesh(const BenchTable *table, const BenchTableRun *run, const char *mesh)
{
    void *scene;
    int code = bench_table_open(run, &voxel_technique, table->id, mesh, &scene);
    if (!scene)
        return code;
    for (size_t i = 0; i < GP_COUNT(rows) && !code; i++) {
        SizesMeasured measured;
        GpError error = { "" };
        if (measure_row(&run->clock, scene, &rows[i], &measured, &error))
            code = report(EXIT_INPUT, "%s: %s", mesh, error.text);
        else if (run->options->json)
            print_json(table, mesh, &rows[i], &measured);
        else
            print_text(mesh, &rows[i], &measured);
    }
    voxel_technique.close(scene);
    return code;
}

static int run_sizes(const BenchTable *table, const BenchTableRun *run)
{
    int code = EXIT_DONE;
    if (!run->options->json)
        print_head();
    for (size_t i = 0; i < GP_COUNT(meshes) && !code; i++)
        code = run_mesh(table, run, meshes[i]);
    return code;
}

const BenchTable bench_table_2_2 = {
    .id = "2.2",
    .title = "voxelization in several resolutions",
    .source = "thesis, chapter 2; Wagner, 60246 triangles, for whom other models stand in",
    .run = run_sizes,
};
