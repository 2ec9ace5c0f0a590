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

GpResult technique_time(const TechniqueClock *clock, const Technique *technique, void *scene,
                        const char *options, Frame *frame, RunStatistics *statistics,
                        Timing *timing, GpError *error)
{
    GpResult result = technique_build(technique, scene, options, clock->device, frame, error);
    if (result)
        return result;
    result = run_first(clock->device, &frame->list, statistics, error);
    if (!result)
        result = timing_run(clock->device, &frame->list, &clock->plan, clock->each, statistics,
                            timing, error);
    if (result)
        frame_free(frame);
    return result;
}
