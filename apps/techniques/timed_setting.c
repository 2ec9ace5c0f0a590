#include "apps/techniques/timed_setting.h"

GpResult technique_time(const TechniqueClock *clock, const Technique *technique, void *scene,
                        const char *options, Work *work, Frame *frame, Timing *timing,
                        GpError *error)
{
    GpResult result = technique_build(technique, scene, options, work, error);
    if (result)
        return result;
    result = frame_first(clock->device, &work->list, frame, error);
    if (!result)
        result =
            timing_run(clock->device, &work->list, &clock->plan, clock->each, frame, timing, error);
    if (result)
        work_free(work);
    return result;
}
