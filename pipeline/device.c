/* Devices: they choose an executor and a width of lanes, and keep counters and times. */
#include <glasspipe/glasspipe.h>

#include "pipeline/base/clock.h"
#include "pipeline/fast/fast.h"
#include "pipeline/base/fpcontrol.h"
#include "pipeline/list/isa.h"
#include "pipeline/list/list_check.h"
#include "pipeline/watched.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_THREADS = 1024 };

struct GpDevice {
    GpDeviceDesc desc;
    char isa[16];     /* as asked for; desc.isa may have been freed by the caller */
    int forced_lanes; /* 0: chosen for each list */
    char used_isa[16];
    GpFast *fast;               /* NULL: the reference executor */
    GpCheckedPrograms programs; /* of the reference executor; the other has its own */
    GpCounters counters;
    GpPhases phases;
};

static GpResult check_isa(const char *name, GpError *error)
{
    int lanes = gp_isa_lanes(name);
    if (lanes < 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "isa '%s': expected auto, sse2, avx2, avx512 or neon", name);
    bool by_width = name && strncmp(name, "lanes", 5) == 0;
    if (lanes > 0 && ((!by_width && !gp_isa_runs(name)) || !gp_isa_of_lanes(lanes)))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "isa '%s': this processor, or this build, does not have it", name);
    return GP_OK;
}

/* A copy: what names it may be a program's code, which does not outlive its library. */
static void use_isa(GpDevice *device, const char *name)
{
    strncpy(device->used_isa, name, sizeof device->used_isa - 1);
    device->used_isa[sizeof device->used_isa - 1] = '\0';
}

static int processors(void)
{
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online < 1 ? 1 : online > MAX_THREADS ? MAX_THREADS : (int)online;
}

GpResult gp_device_create(const GpDeviceDesc *desc, GpDevice **device, GpError *error)
{
    if ((unsigned)desc->executor >= GP_EXECUTORS)
        return gp_fail(error, GP_ERROR_INVALID, "executor: unknown");
    if (desc->threads < 0 || desc->threads > MAX_THREADS)
        return gp_fail(error, GP_ERROR_INVALID, "threads: %d, expected 0 to %d", desc->threads,
                       MAX_THREADS);
    const bool is_fast = desc->executor == GP_EXECUTOR_FAST;
    if (desc->trace.event && desc->trace.only_wanted != is_fast)
        return gp_fail(error, GP_ERROR_INVALID,
                       is_fast ? "trace: only the reference executor has one of everything"
                               : "trace: only_wanted is for the fast executor");
    const char *isa = desc->isa;
    const char *usual = getenv("GP_ISA");
    if (gp_isa_lanes(isa) == 0 && usual && usual[0])
        isa = usual;
    GpResult result = check_isa(isa, error);
    if (result)
        return result;
    GpDevice *d = gp_alloc(1, sizeof *d);
    if (!d)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for a device");
    d->desc = *desc;
    if (desc->executor == GP_EXECUTOR_FAST) {
        result = gp_fast_create(desc->threads ? desc->threads : processors(), &d->fast, error);
        if (result) {
            gp_free(d);
            return result;
        }
    }
    d->forced_lanes = gp_isa_lanes(isa);
    if (d->forced_lanes)
        strncpy(d->isa, isa, sizeof d->isa - 1);
    use_isa(d, d->forced_lanes ? d->isa : "auto");
    *device = d;
    return GP_OK;
}

void gp_device_destroy(GpDevice **device)
{
    if (!device || !*device)
        return;
    gp_fast_destroy(&(*device)->fast);
    gp_free(*device);
    *device = NULL;
}

/* The widest lanes that the build has and the processor runs. */
static int widest_lanes(void)
{
    int lanes = 16;
    while (lanes > 4 && !gp_isa_of_lanes(lanes))
        lanes /= 2;
    return lanes;
}

/* The width that was forced, else the widest. The reference executor works on single quads, gains
 * nothing from wider code, and takes the narrowest. */
static int first_choice(const GpDevice *device)
{
    return device->forced_lanes ? device->forced_lanes : device->fast ? widest_lanes() : 4;
}

/* The width to run a list at: the first choice, or the widest below it that every program has. */
static GpResult choose_lanes(GpDevice *device, const GpList *list, int *lanes, GpError *error)
{
    const GpProgram *missing;
    *lanes = first_choice(device);
    while (!gp_isa_serves(list, *lanes, &missing)) {
        if (device->forced_lanes || *lanes == 4)
            return gp_fail(error, GP_ERROR_UNSUPPORTED,
                           "program %s was not compiled for %d lanes that this processor runs",
                           missing->name, *lanes);
        *lanes /= 2;
    }
    const char *used = gp_isa_of_lanes(*lanes);
    for (uint32_t p = 0; p < list->pass_count; p++)
        if (list->passes[p].draw_count)
            used = gp_program_code(list->passes[p].draws[0].program, *lanes)->isa;
    use_isa(device, used);
    return GP_OK;
}

GpResult gp_device_run(GpDevice *device, const GpList *list, GpError *error)
{
    int lanes;
    double mark = fast_clock_ms();
    GpIndexRanges ranges = { .pool = NULL };
    GpResult result = device->fast ? gp_fast_check(device->fast, list, first_choice(device), error)
                                   : gp_list_check_again(list, &device->programs, &ranges, error);
    if (result)
        return result;
    result = choose_lanes(device, list, &lanes, error);
    if (result)
        return result;

    const GpProgram *missing;
    const bool is_narrow = !device->forced_lanes && gp_isa_serves(list, 4, &missing);
    GpReference reference = {
        .lanes = is_narrow ? 4 : lanes,
        .trace = device->desc.trace.event ? &device->desc.trace : NULL,
        .counters = &device->counters,
    };
    GpFpControl control = gp_fp_enter();
    device->phases = (GpPhases){ .prepare = fast_clock_lap(&mark) };
    if (!device->fast)
        result = gp_reference_run(&reference, list, error);
    else if (reference.trace)
        result = gp_watched_run(&reference, device->fast, list, lanes, device->desc.timed,
                                &device->counters, &device->phases, error);
    else
        result = gp_fast_run(device->fast, list, lanes, device->desc.timed, &device->counters,
                             &device->phases, error);
    gp_fp_leave(control);
    return result;
}

const char *gp_device_isa(const GpDevice *device)
{
    return device->used_isa;
}

GpExecutor gp_device_executor(const GpDevice *device)
{
    return device->desc.executor;
}

int gp_device_threads(const GpDevice *device)
{
    return device->fast ? gp_fast_threads(device->fast) : 1;
}

const GpCounters *gp_device_counters(const GpDevice *device)
{
    return &device->counters;
}

const GpPhases *gp_device_phases(const GpDevice *device)
{
    return &device->phases;
}
