/* Settings of techniques against the clock. */
#ifndef APPS_TECHNIQUES_TIMED_SETTING_H
#define APPS_TECHNIQUES_TIMED_SETTING_H

#include "apps/techniques/technique.h"
#include "apps/frame/timing.h"

/* Where and for how long. */
typedef struct TechniqueClock {
    GpDevice *device;
    TimingPlan plan;
    double *each; /* room for TIMING_MAX_FRAMES numbers */
} TechniqueClock;

/* The clock of charts: so many seconds for each setting, longer for a slow one's first five frames.
 * owns the caller, until gp_free of each. errors GP_ERROR_MEMORY */
GpResult technique_clock_open(GpDevice *device, double seconds, TechniqueClock *clock,
                              GpError *error);

/* Builds the frame of a setting, a text of options, and draws it by the clock's plan.
 * in     frame: zeroed
 * out    frame: as it was drawn; statistics: of the last; timing
 * errors those of technique_build and gp_device_run; *frame is then empty
 * owns   the caller, until frame_free */
GpResult technique_time(const TechniqueClock *clock, const Technique *technique, void *scene,
                        const char *options, Frame *frame, RunStatistics *statistics,
                        Timing *timing, GpError *error);

#endif
