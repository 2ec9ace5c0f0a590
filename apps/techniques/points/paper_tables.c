#include "apps/techniques/points/paper_tables.h"

#include "apps/points/compress.h"
#include "apps/techniques/points/model.h"

#include <math.h>

/* --- 3.1: bits of a point --------------------------------------------------------------------- */

enum { BEFORE, AFTER, PRINTED_OFF, OURS_OFF };

static const PaperColumn bit_columns[] = {
    [BEFORE] = { "before", PAPER_GIVEN, 0 },
    [AFTER] = { "after", PAPER_BOTH, 0 },
    [PRINTED_OFF] = { "off_as_printed", PAPER_MEASURED, 4 },
    [OURS_OFF] = { "off_ours", PAPER_MEASURED, 4 },
    { .name = NULL },
};

enum { POSITION, NORMAL, TANGENTS, CORNER, RADIUS, TOTAL };

#define BIT_SCENE "builtin:knot"
static const PaperRow bit_rows[] = {
    [POSITION] = { "position", BIT_SCENE, false, { 96, 32 } },
    [NORMAL] = { "normal", BIT_SCENE, false, { 96, 16 } },
    [TANGENTS] = { "tangents", BIT_SCENE, false, { 192, 4 } },
    [CORNER] = { "texture coordinates", BIT_SCENE, false, { 64, 2 } },
    [RADIUS] = { "radius", BIT_SCENE, false, { 32, 8 } },
    [TOTAL] = { "total", BIT_SCENE, false, { 480, 64 } },
    { .name = NULL },
};

/* How far a surfel is off: its place in thousandths of the patch's longest half, its normal in
 * degrees, its radius in per cent. */
static double surfel_off(const Surfel *now, const Surfel *then, const Patch *patch, int which)
{
    double square = 0, cosine = 0;
    for (int k = 0; k < 3; k++) {
        const double off = (double)now->position[k] - (double)then->position[k];
        square += off * off;
        cosine += (double)now->normal[k] * (double)then->normal[k];
    }
    switch (which) {
    case POSITION:
        return 1000 * sqrt(square) / fmax((double)patch->box.half[0], 1e-30);
    case NORMAL:
        return acos(fmin(cosine, 1)) * 57.29577951308232;
    case RADIUS:
        return 100 * fabs((double)now->radius / (double)then->radius - 1);
    default:
        return 0;
    }
}

/* The largest of all surfels. */
static double form_off(const Patches *patches, const Compressed *compressed, int which)
{
    double most = 0;
    for (uint32_t p = 0; p < patches->patch_count; p++) {
        const Patch *patch = &patches->patches[p];
        for (uint32_t l = 0; l < patch->level_count; l++) {
            const PatchLevel *level = &patch_levels(patches, patch)[l];
            for (uint32_t i = level->first; i < level->first + level->count; i++) {
                const Surfel now = compressed_surfel(compressed, p, i);
                most = fmax(most, surfel_off(&now, &patches->surfels[i], patch, which));
            }
        }
    }
    return most;
}

static GpResult measure_bits(const PaperTable *table, const PaperRow *row,
                             const Technique *technique, void *scene, const TechniqueClock *clock,
                             double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    /* as compressed_shared.h has it, and 7 of the share */
    static const double kept[] = { 32, 18, 0, 0, 7, 64 };
    const int which = (int)(row - table->rows), threads = gp_device_threads(clock->device);
    PointsModel *model = scene;
    GpPool *pool = NULL;
    (void)technique;
    GpResult result = points_model_structure(model, POINTS_PLAIN, threads, error);
    if (!result)
        result = gp_pool_create(threads, &pool, error);
    for (int form = 0; form < COMPRESS_FORMS && !result; form++) {
        Compressed compressed;
        result = patches_compress(&model->patches, (CompressForm)form, pool, &compressed);
        if (result)
            break;
        measured[form == COMPRESS_PRINTED ? PRINTED_OFF : OURS_OFF] =
            form_off(&model->patches, &compressed, which);
        compressed_free(&compressed);
    }
    measured[AFTER] = kept[which];
    gp_pool_destroy(&pool);
    return gp_fail(error, result, "out of memory");
}

static const PaperTable bits = {
    .id = "3.1",
    .title = "compression of points, in bits",
    .source = "thesis, chapter 3",
    .note =
        "largest errors: of places in thousandths of half a patch, of normals in degrees, of radii "
        "in per cent; ours needs no tangents and no corners, and has 7 bits for the area",
    .columns = bit_columns,
    .rows = bit_rows,
    .measure = measure_bits,
};

/* --- 3.2: adaptive splatting of large models -------------------------------------------------- */

enum { POINTS, DRAWN, FPS, FPS_ALL, FPS_ROUND };

static const PaperColumn model_columns[] = {
    [POINTS] = { "points", PAPER_BOTH, 0 },
    [DRAWN] = { "drawn", PAPER_BOTH, 0 },
    [FPS] = { "fps", PAPER_BOTH, 2 },
    [FPS_ALL] = { "fps_unmerged", PAPER_MEASURED, 2 },
    [FPS_ROUND] = { "fps_sprites", PAPER_MEASURED, 2 },
    { .name = NULL },
};

static const PaperRow model_rows[] = {
    { "Lucy", "meshes/lucy_100k.ply", true, { 10073000, 3071000, 10.25 } },
    { "Dragon", "meshes/dragon_res2.ply", true, { 1280000, 420000, 10.75 } },
    { "Buddha", "meshes/happy_buddha.ply", true, { 1060000, 310000, 15.12 } },
    { "Hip", NULL, false, { 530000, 150000, 38.12 } },
    { "Hand", "meshes/hand_34k.ply", true, { 330000, 110000, 55.23 } },
    { "Lion", "points/lion_takanawa.ply", false, { 180000, 70000, 80.5 } },
    { .name = NULL },
};

/* Frames a second of a setting. drawn: NULL: not asked for */
static GpResult measure_fps(const TechniqueClock *clock, const Technique *technique, void *scene,
                            const char *options, double *fps, double *drawn, GpError *error)
{
    Frame frame = { .color = NULL };
    Timing timing;
    GpResult result = technique_time(clock, technique, scene, options, &frame, &timing, error);
    if (result)
        return result;
    *fps = 1000 / timing.ms;
    if (drawn)
        *drawn = (double)points_model_splats(&frame);
    frame_free(&frame);
    return GP_OK;
}

/* The window of both publications; a technique's scene is opened at its own size. */
static void set_window(PointsModel *model)
{
    model->view.width = model->view.height = 512;
}

static GpResult measure_models(const PaperTable *table, const PaperRow *row,
                               const Technique *technique, void *scene, const TechniqueClock *clock,
                               double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    (void)table, (void)row;
    PointsModel *model = scene;
    set_window(model);
    measured[POINTS] = model->point_count;
    GpResult result = measure_fps(clock, technique, scene, "--method adaptive --detail 0.7",
                                  &measured[FPS], &measured[DRAWN], error);
    if (!result)
        result = measure_fps(clock, technique, scene, "--method adaptive", &measured[FPS_ALL], NULL,
                             error);
    if (!result)
        result = measure_fps(clock, technique, scene, "--method sprites", &measured[FPS_ROUND],
                             NULL, error);
    return result;
}

static const PaperTable models = {
    .id = "3.2",
    .title = "efficiency of adaptive splatting, 512 x 512",
    .source = "thesis, chapter 3: ATI Radeon 9800 Pro; Lucy as sprites without filters",
    .note =
        "points, those drawn after merging, frames a second; then without merging, and as discs "
        "without filters",
    .columns = model_columns,
    .rows = model_rows,
    .measure = measure_models,
};

/* --- 003.3: both filters against adaptive ones ------------------------------------------------ */

enum { EWA_FAR, EWA_NEAR, ADAPTIVE_FAR, ADAPTIVE_NEAR, OURS_FAR, OURS_NEAR };

static const PaperColumn gain_columns[] = {
    [EWA_FAR] = { "ewa_slow", PAPER_BOTH, 2 },
    [EWA_NEAR] = { "ewa_fast", PAPER_BOTH, 2 },
    [ADAPTIVE_FAR] = { "adaptive_slow", PAPER_BOTH, 2 },
    [ADAPTIVE_NEAR] = { "adaptive_fast", PAPER_BOTH, 2 },
    [OURS_FAR] = { "ours_slow", PAPER_MEASURED, 2 },
    [OURS_NEAR] = { "ours_fast", PAPER_MEASURED, 2 },
    { .name = NULL },
};

static const PaperRow gain_rows[] = {
    { "Chameleon", NULL, false, { 58, 174, 60, 202 } },
    { "Lion", "points/lion_takanawa.ply", false, { 90, 101, 93, 119 } },
    { "Dragon", "meshes/dragon_res2.ply", true, { 16.2, 16.48, 17.13, 19.1 } },
    { "Buddha", "meshes/happy_buddha.ply", true, { 16.5, 19.84, 17.3, 22.91 } },
    { "Blade", "meshes/blade_199k.ply", true, { 16.73, 23.8, 17.5, 27.5 } },
    { "Lucy", "meshes/lucy_100k.ply", true, { 1.66, 1.67, 1.78, 1.89 } },
    { .name = NULL },
};

/* From all of the picture to a quarter of it. */
static GpResult measure_gain(const PaperTable *table, const PaperRow *row,
                             const Technique *technique, void *scene, const TechniqueClock *clock,
                             double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    static const char *const settings[] = { "--method ewa", "--method distance",
                                            "--method adaptive" };
    (void)table, (void)row;
    PointsModel *model = scene;
    const Camera whole = model->view.camera;
    GpResult result = GP_OK;
    set_window(model);
    for (size_t i = 0; i < 2 * GP_COUNT(settings) && !result; i++) {
        Camera *camera = &model->view.camera;
        *camera = whole;
        for (int k = 0; k < 3 && i % 2; k++)
            camera->eye[k] += 3 * (whole.eye[k] - whole.at[k]);
        camera->far *= 4;
        result = measure_fps(clock, technique, scene, settings[i / 2], &measured[i], NULL, error);
        if (i % 2 && measured[i] < measured[i - 1]) {
            const double slow = measured[i];
            measured[i] = measured[i - 1];
            measured[i - 1] = slow;
        }
    }
    model->view.camera = whole;
    return result;
}

static const PaperTable gain = {
    .id = "003.3",
    .title = "frames a second of EWA and of adaptive EWA surface splatting",
    .source = "paper 003, table 3, 512 x 512, from near to far",
    .note =
        "both filters; adaptive by distances, as printed; ours: each at the distance where it is "
        "slower, and where it is faster",
    .columns = gain_columns,
    .rows = gain_rows,
    .measure = measure_gain,
};

const PaperTable *const points_tables[] = { &bits, &models, &gain, NULL };
