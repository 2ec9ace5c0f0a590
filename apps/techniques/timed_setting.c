#include "apps/techniques/timed_setting.h"

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
