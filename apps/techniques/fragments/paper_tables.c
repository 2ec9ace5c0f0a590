#include "apps/techniques/fragments/paper_tables.h"

#include "apps/techniques/fragments/report.h"

/* --- 002.1: frames a second ------------------------------------------------------------------- */

enum { TRIANGLES, PIECES, LAYERS, OURS, MDTS, ABS, BDP2, ADP, DDP, DP, SORTED };

static const PaperColumn speed_columns[] = {
    [TRIANGLES] = { "triangles", PAPER_BOTH, 0 },
    [PIECES] = { "pieces", PAPER_BOTH, 0 },
    [LAYERS] = { "layers", PAPER_BOTH, 0 },
    [OURS] = { "convex", PAPER_BOTH, 1 },
    [MDTS] = { "mdts", PAPER_BOTH, 1 },
    [ABS] = { "abs", PAPER_BOTH, 1 },
    [BDP2] = { "bdp2", PAPER_BOTH, 1 },
    [ADP] = { "adp", PAPER_BOTH, 1 },
    [DDP] = { "ddp", PAPER_BOTH, 1 },
    [DP] = { "dp", PAPER_BOTH, 1 },
    [SORTED] = { "sorted", PAPER_MEASURED, 1 },
    { .name = NULL },
};

static const PaperRow speed_rows[] = {
    { "Teapot",
      "meshes/teapot.ply",
      false,
      { 6320, 12, 6, 1083.34, 348.43, 703.32, 412.24, 215.4, 923, 625.45 } },
    { "Person",
      "meshes/man.ply",
      true,
      { 12936, 28, 14, 909.35, 246.34, 653.45, 378.45, 218.34, 366.45, 212.77 } },
    { "Hourgl.",
      "meshes/hourglass.ply",
      true,
      { 38141, 19, 12, 423.43, 78.34, 324.34, 215, 142.34, 219.57, 212.31 } },
    { "Desk",
      NULL,
      false,
      { 56340, 24, 12, 243.32, 36.34, 139.34, 317.35, 214.34, 160.24, 141.46 } },
    { "Horse",
      "meshes/horse.ply",
      false,
      { 96966, 68, 8, 403.25, 178.34, 394.56, 212.77, 128.21, 75.79, 51.18 } },
    { "Hand",
      "meshes/hand_34k.ply",
      true,
      { 654666, 103, 10, 273.46, 97.36, 263.43, 141.42, 106.45, 44.29, 26.6 } },
    { .name = NULL },
};

static const char *const speed_methods[] = {
    [OURS] = "--method convex --pieces outward",
    [MDTS] = "--method mdt",
    [ABS] = "--method abuffer",
    [BDP2] = "--method bucket2",
    [ADP] = "--method adaptive",
    [DDP] = "--method ddp",
    [DP] = "--method dp",
    [SORTED] = "--method sorted",
};

/* Of the default view: the paper takes the mean of some around the model, and does not say
 * which. */
static GpResult measure_speed(const PaperTable *table, const PaperRow *row,
                              const Technique *technique, void *scene, const TechniqueClock *clock,
                              double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    FragmentModel *model = scene;
    GpResult result = GP_OK;
    (void)table, (void)row;
    for (int i = OURS; i <= SORTED && !result; i++) {
        double ms = 0;
        result = technique_time_ms(clock, technique, scene, speed_methods[i], &ms, error);
        measured[i] = result ? 0 : 1000 / ms;
    }
    if (result)
        return result;
    measured[TRIANGLES] = model->mesh.triangle_count;
    measured[PIECES] = model->facts->pieces;
    measured[LAYERS] = model->count.layers;
    return GP_OK;
}

static const char *const speed_reasons[] = {
    "convex is first here as it was there, and last of all loses to what sorts in the tile.",
    "mdts and abs fall behind the buckets, which the A-buffer led: CUDA appends to a pixel's list "
    "by an atomic operation, in one reading of the mesh; here are none, and each layer of a list "
    "takes a reading.",
    "adp overtakes dual peeling where layers are many: it reads the mesh twice, however many there "
    "are, and a reading costs a processor more than it cost the board.",
    "ddp falls behind dp where the mesh is small and has few layers: it reads half as often, but "
    "blends float targets where dp tests a depth, and there pixels are what is paid for.",
    NULL
};

static const PaperTable speed = {
    .id = "002.1",
    .title = "frames a second of transparent models",
    .source = "paper 002, table 1, 512 x 512, NVidia GTX 280",
    .note =
        "convex pieces, as printed; the multi-depth test and the A-buffer of CUDA, bucket "
        "peeling in two passes and adaptive, dual and single peeling; then sorted by the machine",
    .reasons = speed_reasons,
    .columns = speed_columns,
    .rows = speed_rows,
    .measure = measure_speed,
};

/* --- 002.2: depth ----------------------------------------------------------------------------- */

enum { DEEP_TRIANGLES, DEEP_PIECES, DEEP_OURS, DEEP_DDP, DEEP_DP, DEEP_SORTED };

static const PaperColumn deep_columns[] = {
    [DEEP_TRIANGLES] = { "triangles", PAPER_BOTH, 0 },
    [DEEP_PIECES] = { "pieces", PAPER_BOTH, 0 },
    [DEEP_OURS] = { "convex", PAPER_MEASURED, 2 },
    [DEEP_DDP] = { "ddp", PAPER_MEASURED, 2 },
    [DEEP_DP] = { "dp", PAPER_MEASURED, 2 },
    [DEEP_SORTED] = { "sorted", PAPER_MEASURED, 2 },
    { .name = NULL },
};

#define FEW ":40" /* columns: 1,520 triangles a sphere, where the paper's have 39,600 */

static const PaperRow deep_rows[] = {
    { "16", "builtin:spheres:16" FEW, true, { 1267200, 32 } },
    { "32", "builtin:spheres:32" FEW, true, { 2534400, 64 } },
    { "48", "builtin:spheres:48" FEW, true, { 3801600, 96 } },
    { "64", "builtin:spheres:64" FEW, true, { 5068800, 128 } },
    { "80", "builtin:spheres:80" FEW, true, { 6336000, 160 } },
    { "96", "builtin:spheres:96" FEW, true, { 7603200, 192 } },
    { .name = NULL },
};

enum { DEEP_SIDE = 1024 };

/* The tolerance is what corners are rounded by, so that each sphere is one piece. */
#define CONVEX_SPHERES "--method convex --tolerance 0.00001"

static void set_side(FragmentModel *model, uint32_t side)
{
    const Camera camera = model->view.camera;
    model->view.width = model->view.height = side;
    fragment_model_look(model, &camera);
}

static GpResult measure_depth(const PaperTable *table, const PaperRow *row,
                              const Technique *technique, void *scene, const TechniqueClock *clock,
                              double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    static const char *const methods[] = { [DEEP_OURS] = CONVEX_SPHERES,
                                           [DEEP_DDP] = "--method ddp",
                                           [DEEP_DP] = "--method dp",
                                           [DEEP_SORTED] = "--method sorted" };
    FragmentModel *model = scene;
    GpResult result = GP_OK;
    (void)table, (void)row;
    set_side(model, DEEP_SIDE);
    for (int i = DEEP_OURS; i <= DEEP_SORTED && !result; i++) {
        double ms = 0;
        result = technique_time_ms(clock, technique, scene, methods[i], &ms, error);
        measured[i] = result ? 0 : 1000 / ms;
    }
    if (result)
        return result;
    measured[DEEP_TRIANGLES] = model->mesh.triangle_count;
    measured[DEEP_PIECES] = model->facts->pieces;
    return GP_OK;
}

static const char *const deep_reasons[] = {
    "Convex pieces read the mesh once, peeling once a layer, dual peeling once for two: they leave "
    "peeling behind by the more, the deeper the scene is.",
    NULL
};

static const PaperTable depth = {
    .id = "002.2",
    .title = "frames a second of scenes of growing depth",
    .source = "paper 002, table 2, 1024 x 1024; its frames a second are not in the copy at hand",
    .note = "layers of spheres, 1,520 triangles each instead of 39,600; frames a second of convex "
            "pieces, of dual and single peeling, and sorted by the machine",
    .reasons = deep_reasons,
    .columns = deep_columns,
    .rows = deep_rows,
    .measure = measure_depth,
};

/* --- 002.3: memory ---------------------------------------------------------------------------- */

enum { BYTES_OURS, BYTES_MDTS, BYTES_ABS, BYTES_DDP, BYTES_DP };

static const PaperColumn memory_columns[] = {
    [BYTES_OURS] = { "convex", PAPER_BOTH, 1 }, [BYTES_MDTS] = { "mdts", PAPER_BOTH, 1 },
    [BYTES_ABS] = { "abs", PAPER_MEASURED, 1 }, [BYTES_DDP] = { "ddp", PAPER_MEASURED, 1 },
    [BYTES_DP] = { "dp", PAPER_MEASURED, 1 },   { .name = NULL },
};

static const PaperRow memory_rows[] = {
    { "20, 512", "builtin:spheres:20" FEW, true, { 4, -1 } },
    { "20, 1024", "builtin:spheres:20" FEW, true, { 16, -1 } },
    { "60, 512", "builtin:spheres:60" FEW, true, { 4, -1 } },
    { "60, 1024", "builtin:spheres:60" FEW, true, { 16, 240 } },
    { .name = NULL },
};

static GpResult measure_memory(const PaperTable *table, const PaperRow *row,
                               const Technique *technique, void *scene, const TechniqueClock *clock,
                               double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    static const char *const methods[] = { [BYTES_OURS] = CONVEX_SPHERES,
                                           [BYTES_MDTS] = "--method mdt",
                                           [BYTES_ABS] = "--method abuffer",
                                           [BYTES_DDP] = "--method ddp",
                                           [BYTES_DP] = "--method dp" };
    GpResult result = GP_OK;
    set_side(scene, (row - table->rows) % 2 ? 1024 : 512);
    for (size_t i = 0; i < GP_COUNT(methods) && !result; i++) {
        Frame frame = { .color = NULL };
        result = technique_build(technique, scene, methods[i], clock->device, &frame, error);
        if (!result)
            measured[i] = (double)fragment_work(scene, &frame).bytes / (1 << 20);
        frame_free(&frame);
    }
    return result;
}

static const PaperTable memory = {
    .id = "002.3",
    .title = "memory by layers and size of the picture",
    .source = "paper 002, section 5.2 and table 3, of which the copy at hand has these numbers",
    .note =
        "MB of surfaces beside the picture. Lists have entries of 16 bytes here, and the surfaces "
        "that they are put in order by",
    .columns = memory_columns,
    .rows = memory_rows,
    .measure = measure_memory,
};

const PaperTable *const fragment_tables[] = { &speed, &depth, &memory, NULL };
