/* Benchmark cases of depth images: the bunny from in front of it, with waves of colour that no
 * light changes, seen from 12 degrees aside. */
#include "apps/bench/cases.h"
#include "apps/bench/made.h"
#include "apps/techniques/warp/report.h"
#include "apps/techniques/warp/technique.h"

enum {
    SIDE = 512,
    ROUND_WIDTH = 1024,
    ROUND_HEIGHT = 768
}; /* of pictures; round ones as the paper's */

static const char *const cases[] = {
    [WARP_CASE_PLANAR] = "--method direct",
    [WARP_CASE_LAYERS] = "--method layers",
    [WARP_CASE_PRINTED] = "--method planar",
    [WARP_CASE_DMESH] = "--method dmesh",
    [WARP_CASE_DISPLACEMENT] = "--method displacement",
    [WARP_CASE_RELIEF_TEXTURE] = "--method relief-texture",
    [WARP_CASE_RELIEF] = "--method relief",
    [WARP_CASE_POLYGONS] = "--method polygons",
    [WARP_CASE_CYLINDER] = "--kind cylinder --method surface",
    [WARP_CASE_CYLINDER_PRINTED] = "--kind cylinder --method cylinder",
};

#define WAVES 100 /* over the diagonal of the model's box */

static void set_view(WarpModel *model)
{
    static const Camera source = { .eye = { -0.0168, 0.14, 0.40 },
                                   .at = { -0.0168, 0.1105, -0.0014 },
                                   .up = { 0, 1, 0 },
                                   .fovy = 30,
                                   .near = 0.1,
                                   .far = 2 };
    double diagonal[3];
    vector_subtract(model->bounds.high, model->bounds.low, diagonal);
    model->polygons.waves = WAVES / sqrt(vector_dot(diagonal, diagonal));
    model->lit = false;
    model->source = source;
    model->fixed = source;
    model->fixed.eye[0] = 0.06;
    model->fixed.eye[1] = 0.16;
    model->fixed.eye[2] = 0.38;
    model->is_fixed = true;
}

GpResult bench_build_warp(const BenchCase *bench, Frame *frame, GpError *error)
{
    BenchMade *made;
    GpResult result = bench_made_create(&warp_technique, cases[bench->variant], &made, error);
    if (result)
        return result;
    const bool is_round = bench->variant >= WARP_CASE_CYLINDER;
    result = bench_made_open(made, "meshes/bunny.ply", is_round ? ROUND_WIDTH : SIDE,
                             is_round ? ROUND_HEIGHT : SIDE, error);
    if (result) {
        bench_made_free(made);
        return result;
    }
    set_view(made->model);
    return bench_made_build(made, true, frame, error);
}

void bench_tell_warp(const Frame *frame, double ms, int threads, bool measures, json_t *object)
{
    const BenchMade *made = frame->held;
    WarpError off;
    (void)ms;
    warp_tell_size(made->model, frame, object);
    json_object_set_new(object, "build_ms", json_real(made->build_ms));
    if (measures && !warp_model_error(made->model, frame, threads, &off, NULL))
        warp_tell_error(&off, object);
}
