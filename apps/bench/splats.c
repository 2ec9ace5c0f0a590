/* Benchmark cases of points: the bunny's vertices as surfels, with waves of colour over them that
 * no light changes; a larger model; and a scan. */
#include "apps/bench/cases.h"
#include "apps/bench/made.h"
#include "apps/techniques/points/technique.h"
#include "apps/techniques/points/model.h"

#include <math.h>

static const struct {
    const char *path, *options;
    uint32_t subdivide;
    OrbitUp up;
    uint32_t side; /* of the picture */
    double waves;  /* over the diagonal of the model's box; 0: lit */
    bool near;     /* the bunny's own camera; else one that shows the whole model */
} cases[] = {
    [SPLATS_EWA_35K] = { "meshes/bunny.ply", "--method ewa", 0, ORBIT_UP_Y, 512, 100, true },
    [SPLATS_EWA_139K] = { "meshes/bunny.ply", "--method ewa", 1, ORBIT_UP_Y, 512, 100, true },
    [SPLATS_EWA_556K] = { "meshes/bunny.ply", "--method ewa", 2, ORBIT_UP_Y, 512, 100, true },
    [SPLATS_MINIFIED] = { "meshes/bunny.ply", "--method ewa", 2, ORBIT_UP_Y, 128, 1500, true },
    [SPLATS_ADAPTIVE] = { "meshes/bunny.ply", "--method adaptive", 2, ORBIT_UP_Y, 512, 100, true },
    [SPLATS_TERNARY] = { "meshes/bunny.ply", "--method ternary", 2, ORBIT_UP_Y, 512, 100, true },
    [SPLATS_ROUND] = { "meshes/bunny.ply", "--method sprites", 2, ORBIT_UP_Y, 512, 100, true },
    [SPLATS_QSPLAT] = { "meshes/bunny.ply", "--method qsplat", 2, ORBIT_UP_Y, 512, 100, true },
    [SPLATS_PIXELS] = { "meshes/happy_buddha.ply", "--method pixels", 2, ORBIT_UP_Y, 1024, 0,
                        false },
    [SPLATS_LEVELS] = { "meshes/happy_buddha.ply", "--method adaptive --detail 0.65", 2, ORBIT_UP_Y,
                        1024, 0, false },
    [SPLATS_SCAN] = { "points/lion_takanawa.ply", "--method adaptive", 0, ORBIT_UP_Z, 1024, 0,
                      false },
};

static void set_view(int variant, PointsModel *model)
{
    static const Camera near = { .eye = { -0.0168, 0.16, 0.40 },
                                 .at = { -0.0168, 0.1105, -0.0014 },
                                 .up = { 0, 1, 0 },
                                 .fovy = 26,
                                 .near = 0.1,
                                 .far = 2 };
    double diagonal[3];
    vector_subtract(model->bounds.high, model->bounds.low, diagonal);
    model->view.waves = cases[variant].waves / sqrt(vector_dot(diagonal, diagonal));
    model->view.lit = !(cases[variant].waves > 0);
    if (cases[variant].near)
        model->view.camera = near;
}

static GpResult open_case(int variant, BenchMade *made, GpError *error)
{
    const uint32_t side = cases[variant].side;
    PointsOptions *options = made->setting;
    options->subdivide = cases[variant].subdivide;
    options->orbit.up = cases[variant].up;
    const GpResult result = bench_made_open(made, cases[variant].path, side, side, error);
    if (!result)
        set_view(variant, made->model);
    return result;
}

GpResult bench_build_splats(const BenchCase *bench, Frame *frame, GpError *error)
{
    BenchMade *made;
    GpResult result =
        bench_made_create(&points_technique, cases[bench->variant].options, &made, error);
    if (result)
        return result;
    result = open_case(bench->variant, made, error);
    if (!result)
        return bench_made_build(made, true, frame, error);
    bench_made_free(made);
    return result;
}

void bench_tell_splats(const Frame *frame, double ms, int threads, bool measures, json_t *object)
{
    const BenchMade *made = frame->held;
    PointsModel *model = made->model;
    const double splats = (double)points_model_splats(frame);
    json_object_set_new(object, "splats", json_integer((json_int_t)splats));
    json_object_set_new(object, "splats_per_second", json_real(splats * 1000 / ms));
    json_object_set_new(object, "bytes_per_point",
                        json_real(points_model_bytes(model, made->setting) / model->point_count));
    json_object_set_new(object, "build_ms", json_real(made->build_ms));
    if (!measures || points_model_truth(model, threads, NULL))
        return;
    const PointsError off = points_error(&model->truth, frame->color);
    json_object_set_new(object, "interior_psnr", json_real(off.interior_psnr));
    json_object_set_new(object, "area_error", json_real(off.area_error));
    json_object_set_new(object, "holes", json_integer((json_int_t)off.holes));
}
