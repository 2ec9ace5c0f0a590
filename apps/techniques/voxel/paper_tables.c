#include "apps/techniques/voxel/paper_tables.h"

#include "apps/techniques/voxel/models.h"
#include "apps/techniques/voxel/sheets_time.h"

#include <stdio.h>

static double megabytes(size_t bytes)
{
    return (double)bytes / (1 << 20);
}

/* --- 2.1: the steps of models of different size ----------------------------------------------- */

enum { SIZE = 256 };
#define AT_SIZE " --size 256" /* the same */

enum { TRIANGLES, RASTER, TEXELIZE, SYNTHESIZE, SORT, SHEETS, CONSERVATIVE, THIN, VOXELS, DRAWN };

static const PaperColumn step_columns[] = {
    [TRIANGLES] = { "triangles", PAPER_BOTH, 0 },
    [RASTER] = { "raster", PAPER_BOTH, 2 },
    [TEXELIZE] = { "texelize", PAPER_BOTH, 2 },
    [SYNTHESIZE] = { "synthesize", PAPER_BOTH, 2 },
    [SORT] = { "sort", PAPER_BOTH, 2 },
    [SHEETS] = { "sheets", PAPER_MEASURED, 2 },
    [CONSERVATIVE] = { "conservative", PAPER_MEASURED, 2 },
    [THIN] = { "thin", PAPER_MEASURED, 2 },
    [VOXELS] = { "voxels", PAPER_MEASURED, 0 },
    [DRAWN] = { "targets_mb", PAPER_MEASURED, 1 },
    { .name = NULL },
};

static const PaperRow step_rows[] = {
    { "Duck", NULL, false, { 1254, 9, 8, 10, 0.8 } },
    { "Hugo", NULL, false, { 16928, 9.7, 8.3, 10, 7 } },
    { "Bunny", "meshes/bunny.ply", false, { 69451, 12, 8, 11, 27 } },
    { "Dragon", "meshes/dragon_res2.ply", true, { 871326, 38, 8, 11, 330 } },
    { "Buddha", "meshes/happy_buddha.ply", false, { 1087514, 47, 7.8, 10, 415 } },
    { "Blade", "meshes/blade_199k.ply", true, { 1765388, 75, 8, 12, 660 } },
    { .name = NULL },
};

static GpResult measure_sheets(const Technique *technique, void *scene, const TechniqueClock *clock,
                               double measured[], GpError *error)
{
    const VoxelModels *models = scene;
    Frame frame = { .color = NULL };
    Timing timing;
    SheetsTimes steps;
    GpResult result =
        technique_time(clock, technique, scene, "--method sheets" AT_SIZE, &frame, &timing, error);
    if (result)
        return result;
    const VoxelMade *made = frame.made;
    measured[SHEETS] = timing.ms;
    measured[VOXELS] = (double)flat_texture_count(&made->pair.result);
    measured[DRAWN] = megabytes(sheets_bytes(&frame.list));
    result = sheets_time_steps(clock, &frame, &steps, error);
    frame_free(&frame);
    if (result)
        return result;
    measured[RASTER] = steps.raster;
    measured[TEXELIZE] = steps.texelize;
    measured[SYNTHESIZE] = steps.synthesize;
    return sheets_time_sort(clock, &models->scene, SIZE, &measured[SORT], error);
}

static GpResult measure_steps(const PaperTable *table, const PaperRow *row,
                              const Technique *technique, void *scene, const TechniqueClock *clock,
                              double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    (void)table, (void)row;
    measured[TRIANGLES] = ((const VoxelModels *)scene)->scene.mesh.triangle_count;
    GpResult result = measure_sheets(technique, scene, clock, measured, error);
    if (!result)
        result = technique_time_ms(clock, technique, scene, "--method conservative" AT_SIZE,
                                   &measured[CONSERVATIVE], error);
    if (!result)
        result = technique_time_ms(clock, technique, scene, "--method thin" AT_SIZE,
                                   &measured[THIN], error);
    return result;
}

static const PaperTable steps = {
    .id = "2.1",
    .title = "efficiency of surface voxelization",
    .source = "thesis, chapter 2",
    .note = "milliseconds at 256 voxels a side; then whole methods, and of the first its voxels "
            "and the megabytes that it draws into",
    .columns = step_columns,
    .rows = step_rows,
    .measure = measure_steps,
};

/* --- 2.2: one model in volumes of several sizes and depths, and pictures of them -------------- */

enum { PICTURE = 512 }; /* pixels a side; the print does not say */

enum { SIDE, BITS, MEMORY, MS, COUNT, PICTURE_MS, MADE_OF };

static const PaperColumn size_columns[] = {
    [SIDE] = { "size", PAPER_GIVEN, 0 },
    [BITS] = { "bits", PAPER_GIVEN, 0 },
    [MEMORY] = { "memory_mb", PAPER_BOTH, 2 },
    [MS] = { "ms", PAPER_BOTH, 2 },
    [COUNT] = { "voxels", PAPER_BOTH, 0 },
    [PICTURE_MS] = { "picture_ms", PAPER_BOTH, 2 },
    [MADE_OF] = { "targets_mb", PAPER_MEASURED, 1 },
    { .name = NULL },
};

/* The print's, Wagner of 60,246 triangles, is not at hand. */
#define ROWS(mesh)                                                                                 \
    { "Wagner", mesh, false, { 512, 1, 16, 500, 620381, 240 } },                                   \
        { "Wagner", mesh, false, { 256, 8, 16, 30, 151347, 10 } },                                 \
        { "Wagner", mesh, false, { 128, 16, 4, 24, 38012, 6 } },                                   \
    {                                                                                              \
        "Wagner", mesh, false,                                                                     \
        {                                                                                          \
            64, 8, 0.25, 21, 9379, 4                                                               \
        }                                                                                          \
    }

static const PaperRow size_rows[] = { ROWS("meshes/bunny.ply"),
                                      ROWS("meshes/happy_buddha.ply"),
                                      { .name = NULL } };

static Camera camera_for(uint32_t size)
{
    const double n = size, centre = n / 2;
    return (Camera){ .eye = { centre + n, centre + 0.8 * n, centre + 2 * n },
                     .at = { centre, centre, centre },
                     .up = { 0, 1, 0 },
                     .fovy = 40,
                     .near = 0.5 * n,
                     .far = 5 * n };
}

static GpResult time_picture(const TechniqueClock *clock, const FlatTexture *texture, double *ms,
                             GpError *error)
{
    Frame frame = { .color = NULL };
    Timing timing = { .ms = 0 };
    VoxelView view = voxel_view_defaults;
    view.camera = camera_for(texture->size);
    GpResult result = voxel_view_build(texture, &view, PICTURE, PICTURE, &frame, error);
    if (!result)
        result = technique_time_list(clock, &frame.list, &timing, error);
    frame_free(&frame);
    *ms = timing.ms;
    return result;
}

/* Pictures are drawn of volumes of one bit. */
static GpResult measure_picture(const Technique *technique, void *scene,
                                const TechniqueClock *clock, uint32_t size, double *ms,
                                GpError *error)
{
    char options[64];
    Frame frame = { .color = NULL };
    snprintf(options, sizeof options, "--method sheets --size %u", size);
    GpResult result = technique_build(technique, scene, options, clock->device, &frame, error);
    if (!result)
        result = gp_device_run(clock->device, &frame.list, error);
    if (!result)
        result = time_picture(clock, &((const VoxelMade *)frame.made)->pair.result, ms, error);
    frame_free(&frame);
    return result;
}

static GpResult measure_sizes(const PaperTable *table, const PaperRow *row,
                              const Technique *technique, void *scene, const TechniqueClock *clock,
                              double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    (void)table;
    char options[64];
    Frame frame = { .color = NULL };
    Timing timing;
    const uint32_t size = (uint32_t)row->printed[SIDE], bits = (uint32_t)row->printed[BITS];
    snprintf(options, sizeof options, "--method sheets --size %u --bits %u", size, bits);
    GpResult result = technique_time(clock, technique, scene, options, &frame, &timing, error);
    if (result)
        return result;
    const VoxelMade *made = frame.made;
    measured[MS] = timing.ms;
    measured[COUNT] = (double)flat_texture_count(&made->pair.result);
    measured[MEMORY] = megabytes(flat_texture_bytes(&made->pair.result));
    measured[MADE_OF] = megabytes(sheets_bytes(&frame.list));
    frame_free(&frame);
    return measure_picture(technique, scene, clock, size, &measured[PICTURE_MS], error);
}

static const PaperTable sizes = {
    .id = "2.2",
    .title = "voxelization in several resolutions",
    .source = "thesis, chapter 2; Wagner, 60246 triangles, for whom other models stand in",
    .note = "megabytes of the volume, and last of all that is drawn into; pictures of 512 x 512 "
            "are of one bit a voxel, whatever the row has",
    .columns = size_columns,
    .rows = size_rows,
    .measure = measure_sizes,
};

const PaperTable *const voxel_tables[] = { &steps, &sizes, NULL };
