#include "apps/frame/run_statistics.h"

#include "apps/base/json.h"
#include "apps/base/machine.h"

#include <inttypes.h>
#include <stdio.h>

enum { COUNTED_BY_ALL = 6 };

/* A device counts on and on. */
static GpCounters counted_since(const GpCounters *before, const GpCounters *now)
{
    return (GpCounters){
        .passes = now->passes - before->passes,
        .draws = now->draws - before->draws,
        .vertices = now->vertices - before->vertices,
        .primitives = now->primitives - before->primitives,
        .primitives_clipped = now->primitives_clipped - before->primitives_clipped,
        .fragments_shaded = now->fragments_shaded - before->fragments_shaded,
        .primitives_drawn = now->primitives_drawn - before->primitives_drawn,
        .fragments = now->fragments - before->fragments,
        .pixels_written = now->pixels_written - before->pixels_written,
    };
}

GpResult run_first(GpDevice *device, const GpList *list, RunStatistics *statistics, GpError *error)
{
    const GpCounters before = *gp_device_counters(device);
    double start = machine_clock_ms(CLOCK_MONOTONIC);
    double cpu = machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID);
    GpResult result = gp_device_run(device, list, error);
    if (result)
        return result;
    *statistics = (RunStatistics){ .first_ms = machine_clock_ms(CLOCK_MONOTONIC) - start,
                                   .first_cpu_ms = machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID) - cpu,
                                   .counters = counted_since(&before, gp_device_counters(device)),
                                   .phases = *gp_device_phases(device),
                                   .isa = gp_device_isa(device),
                                   .executor = gp_device_executor(device),
                                   .threads = gp_device_threads(device) };
    return GP_OK;
}

GpResult run_again(GpDevice *device, const GpList *list, RunStatistics *statistics, GpError *error)
{
    double start = machine_clock_ms(CLOCK_MONOTONIC),
           cpu = machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID);
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
    const GpCounters *counters = &statistics->counters;
    const struct {
        const char *name;
        uint64_t value;
    } counted[] = {
        { "passes", counters->passes },
        { "draws", counters->draws },
        { "vertices", counters->vertices },
        { "primitives", counters->primitives },
        { "primitives_clipped", counters->primitives_clipped },
        { "fragments_shaded", counters->fragments_shaded },
        /* the reference executor's alone */
        { "primitives_drawn", counters->primitives_drawn },
        { "fragments", counters->fragments },
        { "pixels_written", counters->pixels_written },
    };
    /* what the fast executor does not count is left out, not reported as 0 */
    size_t known =
        statistics->executor == GP_EXECUTOR_REFERENCE ? GP_COUNT(counted) : COUNTED_BY_ALL;
    for (size_t i = 0; i < known; i++)
        json_object_set_new(object, counted[i].name, json_integer((json_int_t)counted[i].value));
}

json_t *run_json(const RunStatistics *statistics, uint64_t hash, const GpSurface *surface)
{
    char digits[17];
    snprintf(digits, sizeof digits, "%016" PRIx64, hash);
    json_t *object = json_pack(
        "{s:s, s:s, s:I, s:I, s:o, s:o, s:o, s:i, s:s}", "hash", digits, "format",
        gp_format_info(surface->format)->name, "width", (json_int_t)surface->width, "height",
        (json_int_t)surface->height, "ms", json_number(statistics->ms), "first_ms",
        json_number(statistics->first_ms), "cpu_ms", json_number(statistics->cpu_ms), "threads",
        statistics->threads, "isa", statistics->isa);
    run_add_counters(statistics, object);
    return object;
}
