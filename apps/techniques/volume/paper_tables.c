#include "apps/techniques/volume/paper_tables.h"

#include "apps/techniques/volume/methods.h"
#include "pipeline/shader/counts.h"
#include "shaders_c/points/splat.h"
#include "shaders_c/volume/splat.h"

#include <string.h>

#define ENGINE "volumes/engine.raw.gz"
#define BONSAI "volumes/bonsai.raw.gz"
#define HEAD   "volumes/vismale.raw.gz"

/* --- 003.1: slots ----------------------------------------------------------------------------- */

static const PaperColumn slot_columns[] = {
    { "ewa", PAPER_BOTH, 0 },
    { "reconstruction", PAPER_BOTH, 0 },
    { "lowpass", PAPER_BOTH, 0 },
    { "pixel_ewa", PAPER_MEASURED, 0 },
    { "pixel_rec", PAPER_MEASURED, 0 },
    { "pixel_low", PAPER_MEASURED, 0 },
    { .name = NULL },
};

#define NO_SCENE "builtin:ball:4" /* shaders are counted, and nothing is drawn */
static const PaperRow slot_rows[] = {
    { "Volume", NO_SCENE, false, { 42, 32, 28 } },
    { "Rectil.", NULL, false, { 46, 32, 28 } },
    { "Points", NO_SCENE, false, { 49, 40, 32 } },
    { .name = NULL },
};

static GpResult measure_slots(const PaperTable *table, const PaperRow *row,
                              const Technique *technique, void *scene, const TechniqueClock *clock,
                              double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    static const GpProgram *const volumes[] = { &voxel_ewa_program, &voxel_reconstruction_program,
                                                &voxel_low_pass_program };
    (void)technique, (void)scene, (void)clock;
    for (int i = 0; i < 3; i++) {
        const GpProgram *program = row == table->rows ? volumes[i] : &splat_color_program;
        GpShaderCounts vertex = { 0 }, pixel = { 0 };
        if (program->count && !program->count(program, &vertex, &pixel))
            return gp_fail(error, GP_ERROR_MEMORY, "no memory to count instructions");
        measured[i] = vertex.slots;
        measured[3 + i] = pixel.slots;
    }
    return GP_OK;
}

static const PaperTable slots = {
    .id = "003.1",
    .title = "instructions of vertex shaders",
    .source = "paper 003, table 1",
    .note = "slots of the vertex shaders, and of the pixel shaders; of points one shader has all "
            "filters",
    .columns = slot_columns,
    .rows = slot_rows,
    .measure = measure_slots,
};

/* --- what is drawn ---------------------------------------------------------------------------- */

/* Engine and bonsai have transfer functions of their own. */
static GpResult set_transfer(const PaperRow *row, VolumeModel *model, GpError *error)
{
    const char *name = strcmp(row->scene, ENGINE) == 0   ? "engine"
                       : strcmp(row->scene, BONSAI) == 0 ? "bonsai"
                                                         : NULL;
    return name ? transfer_open(name, &model->field, &model->transfer, error) : GP_OK;
}

static GpResult find_fps(const TechniqueClock *clock, const Technique *technique, void *scene,
                         const char *options, double *fps, GpError *error)
{
    double ms;
    const GpResult result = technique_time_ms(clock, technique, scene, options, &ms, error);
    *fps = result ? 0 : 1000 / ms;
    return result;
}

/* --- 003.2: adaptive filters ------------------------------------------------------------------ */

enum { EWA_NEAR, ADAPTIVE_NEAR, EWA_FAR, ADAPTIVE_FAR, BOUNDED_NEAR, BOUNDED_FAR };

static const PaperColumn gain_columns[] = {
    [EWA_NEAR] = { "ewa_near", PAPER_BOTH, 2 },
    [ADAPTIVE_NEAR] = { "adaptive_near", PAPER_BOTH, 2 },
    [EWA_FAR] = { "ewa_far", PAPER_BOTH, 2 },
    [ADAPTIVE_FAR] = { "adaptive_far", PAPER_BOTH, 2 },
    [BOUNDED_NEAR] = { "ours_near", PAPER_MEASURED, 2 },
    [BOUNDED_FAR] = { "ours_far", PAPER_MEASURED, 2 },
    { .name = NULL },
};

static const PaperRow gain_rows[] = {
    { "Engine", ENGINE, false, { 18.2, 19.1, 43.15, 49.05 } },
    { "Tree", NULL, false, { 32.05, 34.1, 61.82, 68.65 } },
    { "Head", HEAD, true, { 15.05, 15.97, 31.05, 35.15 } },
    { "Bonsai", BONSAI, true, { 12.85, 13.6, 16.06, 18.1 } },
    { "Carp", NULL, false, { 16.6, 18.03, 26.32, 29.53 } },
    { "Bunny", NULL, false, { 2.6, 2.86, 2.8, 3.2 } },
    { "C-tree", NULL, false, { 3.98, 4.41, 4.5, 5.77 } },
    { .name = NULL },
};

/* Near: the volume fills the window; far: a quarter of it. */
static GpResult measure_gain(const PaperTable *table, const PaperRow *row,
                             const Technique *technique, void *scene, const TechniqueClock *clock,
                             double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    static const struct {
        const char *options;
        bool is_far;
    } columns[] = {
        [EWA_NEAR] = { "--method splat", false },
        [ADAPTIVE_NEAR] = { "--method splat --filter adaptive", false },
        [EWA_FAR] = { "--method splat", true },
        [ADAPTIVE_FAR] = { "--method splat --filter adaptive", true },
        [BOUNDED_NEAR] = { "--method splat --filter bounded", false },
        [BOUNDED_FAR] = { "--method splat --filter bounded", true },
    };
    (void)table;
    VolumeModel *model = scene;
    const Camera whole = model->view.camera;
    GpResult result = set_transfer(row, model, error);
    for (size_t i = 0; i < GP_COUNT(columns) && !result; i++) {
        Camera *camera = &model->view.camera;
        *camera = whole;
        for (int k = 0; k < 3 && columns[i].is_far; k++)
            camera->eye[k] += 3 * (whole.eye[k] - whole.at[k]);
        camera->far *= 4;
        result = find_fps(clock, technique, scene, columns[i].options, &measured[i], error);
    }
    model->view.camera = whole;
    return result;
}

static const PaperTable gain = {
    .id = "003.2",
    .title = "frames a second of EWA and of adaptive EWA volume splatting",
    .source = "paper 003, table 2, 512 x 512, NVidia 6800 GT",
    .note = "both filters, and adaptive by distances, near and far; ours: within a bound",
    .columns = gain_columns,
    .rows = gain_rows,
    .measure = measure_gain,
};

/* --- 003.4: modes ----------------------------------------------------------------------------- */

enum { SPLATS, FIRST_FPS, FIRST_MB = FIRST_FPS + VOXEL_MODES };

static const PaperColumn mode_columns[] = {
    { "splats", PAPER_BOTH, 0 }, { "qd", PAPER_BOTH, 2 },    { "vb", PAPER_BOTH, 2 },
    { "vt", PAPER_BOTH, 2 },     { "pt", PAPER_BOTH, 2 },    { "im", PAPER_BOTH, 2 },
    { "qd_mb", PAPER_BOTH, 1 },  { "vb_mb", PAPER_BOTH, 1 }, { "vt_mb", PAPER_BOTH, 1 },
    { "pt_mb", PAPER_BOTH, 1 },  { "im_mb", PAPER_BOTH, 1 }, { .name = NULL },
};

static const PaperRow mode_rows[] = {
    { "Engine",
      ENGINE,
      false,
      { 594430, 11.21, 27.43, 21.64, 15.66, 2.85, 78.8, 14.3, 36, 36, 14.3 } },
    { "Tree", NULL, false, { 274866, 19, 39, 33.39, 28.55, 4.53, 56.6, 6.6, 36.9, 36.9, 6.6 } },
    { "Head", HEAD, true, { 693032, 8.7, 19.25, 6.8, 11.29, 2.48, 106.1, 16.6, 56.2, 56.2, 16.6 } },
    { "Bonsai",
      BONSAI,
      true,
      { 1445577, -1, 15.35, -1, -1, 1.78, 252.2, 15.4, 205.9, 205.9, 15.4 } },
    { "Carp", NULL, false, { 642659, -1, 21.94, -1, -1, 2.3, 256.6, 34.7, 151.6, 151.6, 34.7 } },
    { "Bunny",
      NULL,
      false,
      { 9449256, -1, 2.75, -1, -1, 0.3, 1172.2, 226.8, 491.9, 491.9, 226.8 } },
    { "C-tree",
      NULL,
      false,
      { 6893663, -1, 4.12, -1, -1, 0.37, 1115.9, 165.4, 619.6, 619.6, 165.4 } },
    { .name = NULL },
};

/* A draw takes some kilobytes here, and an immediate frame has one for each splat. */
enum { MOST_DRAWS = 1500000 };

static GpResult measure_modes(const PaperTable *table, const PaperRow *row,
                              const Technique *technique, void *scene, const TechniqueClock *clock,
                              double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    static const struct {
        VoxelMode mode;
        const char *options;
    } modes[VOXEL_MODES] = {
        { VOXELS_QD, "--method splat --mode qd" }, { VOXELS_VB, "--method splat --mode vb" },
        { VOXELS_VT, "--method splat --mode vt" }, { VOXELS_PT, "--method splat --mode pt" },
        { VOXELS_IM, "--method splat --mode im" },
    };
    (void)table;
    VolumeModel *model = scene;
    VolumeOptions options = volume_option_defaults;
    options.method = VOLUME_SPLAT;
    GpResult result = set_transfer(row, model, error);
    for (int i = 0; i < VOXEL_MODES && !result; i++) {
        if (modes[i].mode != VOXELS_IM || measured[SPLATS] <= MOST_DRAWS)
            result = find_fps(clock, technique, scene, modes[i].options, &measured[FIRST_FPS + i],
                              error);
        if (result)
            break;
        const VolumeMethodRow *splat = &volume_methods[VOLUME_SPLAT];
        options.splats.mode = modes[i].mode;
        measured[SPLATS] = (double)splat->splats(model);
        measured[FIRST_MB + i] = splat->bytes_per_voxel(model, &options) * measured[SPLATS] * 1e-6;
    }
    return result;
}

static const PaperTable modes = {
    .id = "003.4",
    .title = "modes of EWA volume splatting",
    .source = "paper 003, table 4, 512 x 512, NVidia 6800 GT",
    .note = "splats, frames a second, and millions of bytes; im above 1.5 million splats is left "
            "out (0), for its draws take gigabytes here",
    .columns = mode_columns,
    .rows = mode_rows,
    .measure = measure_modes,
};

const PaperTable *const volume_tables[] = { &slots, &gain, &modes, NULL };
