/* Benchmark cases of volumes: three of them, each under a transfer function of its own, from one
 * place. */
#include "apps/bench/made.h"
#include "apps/base/machine.h"
#include "apps/bench/cases.h"
#include "apps/techniques/volume/methods.h"
#include "apps/techniques/volume/report.h"
#include "apps/techniques/volume/technique.h"

#include <math.h>

enum { SIDE = 512 };

#define BONSAI "volumes/bonsai.raw.gz", "bonsai"
#define ENGINE "volumes/engine.raw.gz", "engine"

/* Rays with steps as long as leaves them nearer to the truth than other renderers' that people
 * use. */
static const struct {
    const char *path, *transfer, *options;
} cases[] = {
    [VOLUME_BONSAI] = { BONSAI, "--method raycast --step 2.5" },
    [VOLUME_ENGINE] = { ENGINE, "--method raycast --step 1.2" },
    [VOLUME_MARSCHNER_LOBB] = { "builtin:marschner-lobb", "marschner-lobb",
                                "--method raycast --step 2.5" },
    [VOLUME_SPLAT_BONSAI_VB] = { BONSAI, "--method splat --mode vb" },
    [VOLUME_SPLAT_ENGINE_VB] = { ENGINE, "--method splat --mode vb" },
    [VOLUME_SPLAT_BONSAI_VT] = { BONSAI, "--method splat --mode vt" },
    [VOLUME_SPLAT_BONSAI_PT] = { BONSAI, "--method splat --mode pt" },
    [VOLUME_SPLAT_BONSAI_IM] = { BONSAI, "--method splat --mode im" },
    [VOLUME_SPLAT_BONSAI_QD] = { BONSAI, "--method splat --mode qd" },
};

static GpResult open_case(int variant, BenchMade *made, GpError *error)
{
    static const Camera camera = { .eye = { 330, 230, 560 },
                                   .at = { 127.5, 127.5, 127.5 },
                                   .up = { 0, 1, 0 },
                                   .fovy = 40,
                                   .near = 1,
                                   .far = 2000 };
    VolumeOptions *options = made->setting;
    options->transfer = cases[variant].transfer;
    const GpResult result = bench_made_open(made, cases[variant].path, SIDE, SIDE, error);
    if (!result)
        ((VolumeModel *)made->model)->view.camera = camera;
    return result;
}

/* What is made once is not made before where it is little beside a draw for each splat. */
GpResult bench_build_volume(const BenchCase *bench, Frame *frame, GpError *error)
{
    BenchMade *made;
    GpResult result =
        bench_made_create(&volume_technique, cases[bench->variant].options, &made, error);
    if (result)
        return result;
    result = open_case(bench->variant, made, error);
    if (!result)
        return bench_made_build(
            made, ((const VolumeOptions *)made->setting)->splats.mode != VOXELS_IM, frame, error);
    bench_made_free(made);
    return result;
}

/* Takes the model's transfer function, and builds the frame by it. */
static GpResult draw_class(const BenchMade *made)
{
    Frame frame = { .color = NULL };
    const VolumeOptions *options = made->setting;
    GpResult result = volume_methods[options->method].classify(made->model, NULL);
    if (!result)
        result = volume_technique.build(made->model, options, NULL, &frame, NULL);
    frame_free(&frame);
    return result;
}

enum { CHANGES = 5 };

/* What a change of the transfer function takes, to one that hides half of the stops and back,
 * beyond that of building a frame: the mean of both, the least of several times. */
static GpResult time_classes(const BenchMade *made, double *ms)
{
    VolumeModel *model = made->model;
    const Transfer kept = model->transfer;
    GpResult result = GP_OK;
    double least = (double)INFINITY;
    for (int change = 0; change < CHANGES && !result; change++) {
        const double start = machine_clock_ms(CLOCK_THREAD_CPUTIME_ID);
        for (uint32_t i = 0; i < kept.count / 2; i++)
            model->transfer.stops[i].rgba[3] = 0;
        result = draw_class(made);
        model->transfer = kept;
        if (!result)
            result = draw_class(made);
        least = fmin(least, (machine_clock_ms(CLOCK_THREAD_CPUTIME_ID) - start) / 2);
    }
    *ms = fmax(least - made->build_ms, 0);
    return result;
}

void bench_tell_volume(const Frame *frame, double ms, int threads, bool measures, json_t *object)
{
    const BenchMade *made = frame->held;
    const VolumeOptions *options = made->setting;
    VolumeModel *model = made->model;
    VolumeError off;
    double transfer_ms;
    volume_tell_size(model, options, object);
    const json_t *splats = json_object_get(object, "splats");
    if (splats)
        json_object_set_new(object, "splats_per_second",
                            json_real(json_number_value(splats) * 1000 / ms));
    json_object_set_new(object, "build_ms", json_real(made->build_ms));
    if (!measures || volume_error(model, options, frame->color, threads, &off, NULL))
        return;
    json_object_set_new(object, "psnr_data", json_real(off.psnr_data));
    json_object_set_new(object, "psnr_method", json_real(off.psnr_method));
    if (options->splats.mode != VOXELS_IM && !time_classes(made, &transfer_ms))
        json_object_set_new(object, "transfer_ms", json_real(transfer_ms));
}
