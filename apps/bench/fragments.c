/* Benchmark cases of meshes of which all fragments count: three scans, and spheres 96 layers
 * deep. */
#include "apps/bench/cases.h"
#include "apps/bench/made.h"
#include "apps/techniques/fragments/report.h"
#include "apps/techniques/fragments/technique.h"

#define BUNNY                                                                                      \
    "meshes/bunny.ply",                                                                            \
    {                                                                                              \
        .eye = { -0.0168, 0.16, 0.40 }, .at = { -0.0168, 0.1105, -0.0014 }, .up = { 0, 1, 0 },     \
        .fovy = 26, .near = 0.1, .far = 2                                                          \
    }
#define DRAGON                                                                                     \
    "meshes/dragon_100k.ply",                                                                      \
    {                                                                                              \
        .eye = { 0.881341, 1.23388, 5.64058 }, .up = { 0, 1, 0 }, .fovy = 30, .near = 0.705,       \
        .far = 14.1                                                                                \
    }
#define BLADE                                                                                      \
    "meshes/blade_199k.ply",                                                                       \
    {                                                                                              \
        .eye = { 12.9849, 19.267, 208.469 }, .at = { 0.329332, 1.5492, 127.473 },                  \
        .up = { 0, 1, 0 }, .fovy = 30, .near = 10.1, .far = 202                                    \
    }
#define SPHERES                                                                                    \
    "builtin:spheres:96",                                                                          \
    {                                                                                              \
        .fovy = 0                                                                                  \
    } /* as they are seen */

static const struct {
    const char *options, *path;
    Camera camera; /* without far: the model's own */
} cases[] = {
    [FRAGMENTS_CASE_SORTED_BUNNY] = { "--method sorted", BUNNY },
    [FRAGMENTS_CASE_SORTED_DRAGON] = { "--method sorted", DRAGON },
    [FRAGMENTS_CASE_SORTED_BLADE] = { "--method sorted", BLADE },
    [FRAGMENTS_CASE_CONVEX_BUNNY] = { "--method convex", BUNNY },
    [FRAGMENTS_CASE_PEEL_BUNNY] = { "--method dp", BUNNY },
    [FRAGMENTS_CASE_DUAL_BUNNY] = { "--method ddp", BUNNY },
    [FRAGMENTS_CASE_ABUFFER_BUNNY] = { "--method abuffer", BUNNY },
    [FRAGMENTS_CASE_SPHERES_96] = { "--method sorted", SPHERES },
};

GpResult bench_build_fragments(const BenchCase *bench, Frame *frame, GpError *error)
{
    BenchMade *made;
    const Camera *camera = &cases[bench->variant].camera;
    GpResult result =
        bench_made_create(&fragment_technique, cases[bench->variant].options, &made, error);
    if (result)
        return result;
    result = bench_made_open(made, cases[bench->variant].path, BENCH_SIZE, BENCH_SIZE, error);
    if (result) {
        bench_made_free(made);
        return result;
    }
    if (camera->far > 0)
        fragment_model_look(made->model, camera);
    return bench_made_build(made, true, frame, error);
}

void bench_tell_fragments(const Frame *frame, double ms, int threads, bool measures, json_t *object)
{
    const BenchMade *made = frame->held;
    FragmentModel *model = made->model;
    (void)ms;
    fragment_tell_work(model, frame, object);
    json_object_set_new(object, "build_ms", json_real(made->build_ms));
    if (measures && !fragment_model_truth(model, threads, NULL))
        fragment_tell_error(model, frame->color, object);
}
