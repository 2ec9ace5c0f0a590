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

/* Draws a list by the clock's plan, after its first frame. errors those of gp_device_run */
GpResult technique_time_list(const TechniqueClock *clock, const GpList *list, Timing *timing,
                             GpError *error);

/* The same with the frame of a setting, a text of options.
 * in     frame: zeroed
 * out    frame: as it was drawn
 * errors those of technique_build and gp_device_run; *frame is then empty
 * owns   the caller, until frame_free */
GpResult technique_time(const TechniqueClock *clock, const Technique *technique, void *scene,
                        const char *options, Frame *frame, Timing *timing, GpError *error);

/* The same where only the median is wanted. */
GpResult technique_time_ms(const TechniqueClock *clock, const Technique *technique, void *scene,
                           const char *options, double *ms, GpError *error);

#endif
