#include "apps/frame/timing.h"

#include "apps/base/machine.h"

#include <stdlib.h>

static int compare_doubles(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

double timing_median(double *values, size_t count)
{
    qsort(values, count, sizeof *values, compare_doubles);
    return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

static void add_frame(Timing *timing, double *each, double ms, double cpu_ms,
                      const GpPhases *phases)
{
    each[timing->frames++] = ms;
    timing->idle_ms += ms; /* of which the threads' work is taken at the end */
    timing->cpu_ms += cpu_ms;
    timing->phases.prepare += phases->prepare;
    timing->phases.vertices += phases->vertices;
    timing->phases.bins += phases->bins;
    timing->phases.tiles += phases->tiles;
    timing->phases.raster += phases->raster;
    timing->phases.shading += phases->shading;
    timing->phases.transfer += phases->transfer;
}

bool timing_is_over(const TimingPlan *plan, uint32_t frames, double spent_ms)
{
    double limit = frames < plan->least_frames ? plan->most_seconds : plan->seconds;
    return frames == TIMING_MAX_FRAMES || spent_ms >= limit * 1e3;
}

GpResult timing_run(GpDevice *device, const GpList *list, const TimingPlan *plan, double *each,
                    RunStatistics *statistics, Timing *timing, GpError *error)
{
    double start = machine_clock_ms(CLOCK_MONOTONIC);
    bool over = statistics->first_ms >= plan->most_seconds * 1e3 / 2;
    Timing sums = { .frames = 0 };
    if (over)
        add_frame(&sums, each, statistics->first_ms, statistics->first_cpu_ms, &statistics->phases);
    while (!over) {
        GpResult result = run_again(device, list, statistics, error);
        if (result)
            return result;
        add_frame(&sums, each, statistics->ms, statistics->cpu_ms, &statistics->phases);
        over = timing_is_over(plan, sums.frames, machine_clock_ms(CLOCK_MONOTONIC) - start);
    }
    sums.ms = timing_median(each, sums.frames);
    const uint32_t last = sums.frames - 1;
    sums.min_ms = each[0];
    sums.low_ms = each[last / 4];
    sums.high_ms = each[last - last / 4];
    sums.max_ms = each[last];
    sums.cpu_ms /= sums.frames;
    const double idle_ms = sums.idle_ms / sums.frames * statistics->threads - sums.cpu_ms;
    sums.idle_ms = idle_ms > 0 ? idle_ms : 0;
    *timing = sums;
    return GP_OK;
}
