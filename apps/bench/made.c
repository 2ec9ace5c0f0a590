#include "apps/bench/made.h"

#include "apps/base/machine.h"

GpResult bench_made_create(const Technique *technique, const char *options, BenchMade **made,
                           GpError *error)
{
    BenchMade *created = gp_alloc(1, sizeof *created);
    if (!created)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    created->technique = technique;
    const GpResult result = technique_setting(technique, options, &created->setting, error);
    if (result)
        bench_made_free(created);
    else
        *made = created;
    return result;
}

void bench_made_free(void *held)
{
    BenchMade *made = held;
    if (made && made->model)
        made->technique->close(made->model);
    if (made)
        gp_free(made->setting);
    gp_free(made);
}

GpResult bench_made_open(BenchMade *made, const char *path, uint32_t width, uint32_t height,
                         GpError *error)
{
    const TechniqueInput input = {
        .path = path, .width = width, .height = height, .setting = made->setting
    };
    return made->technique->open(&input, &made->model, error);
}

GpResult bench_made_build(BenchMade *made, bool twice, Frame *frame, GpError *error)
{
    const Technique *technique = made->technique;
    GpDevice *device = NULL;
    Frame first = { .color = NULL };
    GpResult result = gp_device_create(&(GpDeviceDesc){ .threads = 0 }, &device, error);
    if (!result && twice)
        result = technique->build(made->model, made->setting, device, &first, error);
    frame_free(&first);
    const double start = machine_clock_ms(CLOCK_THREAD_CPUTIME_ID);
    if (!result)
        result = technique->build(made->model, made->setting, device, frame, error);
    made->build_ms = machine_clock_ms(CLOCK_THREAD_CPUTIME_ID) - start;
    gp_device_destroy(&device);
    frame->held = made;
    frame->release = bench_made_free;
    return result;
}
