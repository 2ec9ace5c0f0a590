#include "apps/frame/run_statistics.h"

#include "apps/base/json.h"
#include "apps/base/machine.h"

#include <inttypes.h>
#include <stdio.h>

/* What is counted; the last three by the reference executor alone. */
enum { COUNTED_BY_ALL = 8 };
static const struct {
    const char *name;
    size_t offset;
} counted[] = {
    { "passes", offsetof(GpCounters, passes) },
    { "draws", offsetof(GpCounters, draws) },
    { "vertices", offsetof(GpCounters, vertices) },
    { "primitives", offsetof(GpCounters, primitives) },
    { "primitives_clipped", offsetof(GpCounters, primitives_clipped) },
    { "fragments_shaded", offsetof(GpCounters, fragments_shaded) },
    { "fragments_sorted", offsetof(GpCounters, fragments_sorted) },
    { "sorted_slices", offsetof(GpCounters, sorted_slices) },
    { "primitives_drawn", offsetof(GpCounters, primitives_drawn) },
    { "fragments", offsetof(GpCounters, fragments) },
    { "pixels_written", offsetof(GpCounters, pixels_written) },
};

static uint64_t *counter(GpCounters *counters, size_t i)
{
    return (void *)((char *)counters + counted[i].offset);
}

GpResult run_first(GpDevice *device, const GpList *list, RunStatistics *statistics, GpError *error)
{
    GpCounters before = *gp_device_counters(device); /* a device counts on and on */
    RunStatistics first = { .ms = 0 };
    GpResult result = run_again(device, list, &first, error);
    if (result)
        return result;
    *statistics = (RunStatistics){ .first_ms = first.ms,
                                   .first_cpu_ms = first.cpu_ms,
                                   .counters = *gp_device_counters(device),
                                   .phases = first.phases,
                                   .isa = gp_device_isa(device),
                                   .executor = gp_device_executor(device),
                                   .threads = gp_device_threads(device) };
    for (size_t i = 0; i < GP_COUNT(counted); i++)
        *counter(&statistics->counters, i) -= *counter(&before, i);
    return GP_OK;
}

GpResult run_again(GpDevice *device, const GpList *list, RunStatistics *statistics, GpError *error)
{
    double start = machine_clock_ms(CLOCK_MONOTONIC);
    double cpu = machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID);
    GpResult result = gp_device_run(device, list, error);
    if (result)
        return result;
    statistics->ms = machine_clock_ms(CLOCK_MONOTONIC) - start;
    statistics->cpu_ms = machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID) - cpu;
    statistics->phases = *gp_device_phases(device);
    return GP_OK;
}

void run_add_counters(const RunStatistics *statistics, json_t *object)
{
    GpCounters counters = statistics->counters;
    /* what the fast executor does not count is left out, not reported as 0 */
    size_t known =
        statistics->executor == GP_EXECUTOR_REFERENCE ? GP_COUNT(counted) : COUNTED_BY_ALL;
    for (size_t i = 0; i < known; i++)
        json_object_set_new(object, counted[i].name,
                            json_integer((json_int_t)*counter(&counters, i)));
}

json_t *run_json(const RunStatistics *statistics, uint64_t hash, const GpSurface *surface)
{
    char digits[17];
    snprintf(digits, sizeof digits, "%016" PRIx64, hash);
    json_t *object = json_pack(
        "{s:s, s:s, s:I, s:I, s:o, s:o, s:o, s:i, s:s}", "hash", digits, "format",
        gp_format_info(surface->format)->name, "width", (json_int_t)surface->width, "height",
        (json_int_t)surface->height, "ms", json_milliseconds(statistics->ms), "first_ms",
        json_milliseconds(statistics->first_ms), "cpu_ms", json_milliseconds(statistics->cpu_ms),
        "threads", statistics->threads, "isa", statistics->isa);
    run_add_counters(statistics, object);
    return object;
}
