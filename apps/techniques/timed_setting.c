#include "apps/techniques/timed_setting.h"

enum { LEAST_FRAMES = 5, MOST_SECONDS = 4 };

GpResult technique_clock_open(GpDevice *device, double seconds, TechniqueClock *clock,
                              GpError *error)
{
    const double most = seconds > MOST_SECONDS ? seconds : MOST_SECONDS;
    *clock = (TechniqueClock){ device, { seconds, LEAST_FRAMES, most }, NULL };
    clock->each = gp_alloc(TIMING_MAX_FRAMES, sizeof *clock->each);
    return clock->each ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
}

GpResult technique_time_list(const TechniqueClock *clock, const GpList *list, Timing *timing,
                             GpError *error)
{
    RunStatistics statistics;
    GpResult result = run_first(clock->device, list, &statistics, error);
    return result ? result
                  : timing_run(clock->device, list, &clock->plan, clock->each, &statistics, timing,
                               error);
}

GpResult technique_time(const TechniqueClock *clock, const Technique *technique, void *scene,
                        const char *options, Frame *frame, Timing *timing, GpError *error)
{
    GpResult result = technique_build(technique, scene, options, clock->device, frame, error);
    if (!result)
        result = technique_time_list(clock, &frame->list, timing, error);
    if (result)
        frame_free(frame);
    return result;
}

GpResult technique_time_ms(const TechniqueClock *clock, const Technique *technique, void *scene,
                           const char *options, double *ms, GpError *error)
{
    Frame frame = { .color = NULL };
    Timing timing;
    GpResult result = technique_time(clock, technique, scene, options, &frame, &timing, error);
    frame_free(&frame);
    if (!result)
        *ms = timing.ms;
    return result;
}
