#include "apps/techniques/warp/paper_tables.h"

#include "apps/techniques/warp/model.h"

#define BUNNY "meshes/bunny.ply"
#define IGEA  "meshes/igea.ply"
#define PAPER "paper 001, table "
#define BOARD "; 1024 x 768, GeForce FX 5200"

/* Frames a second of a setting, in the paper's window. */
static GpResult find_fps(const TechniqueClock *clock, const Technique *technique, void *scene,
                         const char *options, double *fps, GpError *error)
{
    WarpModel *model = scene;
    double ms = 0;
    model->width = 1024;
    model->height = 768;
    const GpResult result = technique_time_ms(clock, technique, scene, options, &ms, error);
    *fps = result ? 0 : 1000 / ms;
    return result;
}

/* --- 001.1: against polygons ------------------------------------------------------------------ */

enum { PRINTED_512, PRINTED_256, TRIANGLES, POLYGONS, OURS_512, OURS_256 };

static const PaperColumn polygon_columns[] = {
    [PRINTED_512] = { "dpci_512", PAPER_BOTH, 1 },
    [PRINTED_256] = { "dpci_256", PAPER_BOTH, 1 },
    [TRIANGLES] = { "triangles", PAPER_BOTH, 0 },
    [POLYGONS] = { "polygons", PAPER_BOTH, 1 },
    [OURS_512] = { "surface_512", PAPER_MEASURED, 1 },
    [OURS_256] = { "surface_256", PAPER_MEASURED, 1 },
    { .name = NULL },
};

static const PaperRow polygon_rows[] = {
    { "Venus", BUNNY, false, { 67.5, 185.8, 67170, 32.4 } },
    { "Head", IGEA, false, { 67.5, 185.8, 78157, 28.3 } },
    { .name = NULL },
};

#define SMALL    " --source-size 256x256"
#define CYLINDER "--kind cylinder --method "

static GpResult measure_polygons(const PaperTable *table, const PaperRow *row,
                                 const Technique *technique, void *scene,
                                 const TechniqueClock *clock, double measured[PAPER_MAX_COLUMNS],
                                 GpError *error)
{
    static const struct {
        int column;
        const char *options;
    } settings[] = {
        { PRINTED_512, CYLINDER "cylinder" },   { PRINTED_256, CYLINDER "cylinder" SMALL },
        { POLYGONS, "--method polygons" },      { OURS_512, CYLINDER "surface" },
        { OURS_256, CYLINDER "surface" SMALL },
    };
    (void)table, (void)row;
    GpResult result = GP_OK;
    measured[TRIANGLES] = ((const WarpModel *)scene)->mesh.triangle_count;
    for (size_t i = 0; i < GP_COUNT(settings) && !result; i++)
        result = find_fps(clock, technique, scene, settings[i].options,
                          &measured[settings[i].column], error);
    return result;
}

static const PaperTable against_polygons = {
    .id = "001.1",
    .title = "frames a second of cylindrical depth images and of the polygons that they stand for",
    .source = PAPER "1" BOARD,
    .note =
        "dpci as printed, surface ours; the bunny stands in for Venus, Igea, of more triangles, "
        "for the head. Here a triangle of a mesh costs what one of a grid does, so that images "
        "win by as much as they have fewer of them",
    .columns = polygon_columns,
    .rows = polygon_rows,
    .measure = measure_polygons,
};

/* --- 001.2: against rivals -------------------------------------------------------------------- */

static const PaperColumn rival_columns[] = {
    { "ours", PAPER_BOTH, 2 },   { "displacement", PAPER_BOTH, 2 }, { "dmesh", PAPER_BOTH, 2 },
    { "relief", PAPER_BOTH, 2 }, { "layers", PAPER_MEASURED, 2 },   { .name = NULL },
};

static const PaperRow rival_rows[] = {
    { "512x512", IGEA, false, { 68.14, 18.36, 17.47, 5.85 } },
    { .name = NULL },
};

static GpResult measure_rivals(const PaperTable *table, const PaperRow *row,
                               const Technique *technique, void *scene, const TechniqueClock *clock,
                               double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    static const char *const settings[] = { "--method planar", "--method displacement",
                                            "--method dmesh", "--method relief",
                                            "--method layers" };
    (void)table, (void)row;
    GpResult result = GP_OK;
    for (size_t i = 0; i < GP_COUNT(settings) && !result; i++)
        result = find_fps(clock, technique, scene, settings[i], &measured[i], error);
    return result;
}

static const PaperTable against_rivals = {
    .id = "001.2",
    .title = "frames a second of methods that draw depth images",
    .source = PAPER "2" BOARD,
    .note =
        "ours as printed; layers: this project's own, which fills holes too. The model is Igea. A "
        "mesh in the world costs here what a grid moved within a plane does: it is triangles that "
        "are paid for, not matrices or the depth test; and rays by the pixel, as there",
    .columns = rival_columns,
    .rows = rival_rows,
    .measure = measure_rivals,
};

const PaperTable *const warp_tables[] = { &against_polygons, &against_rivals, NULL };
