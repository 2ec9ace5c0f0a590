/* Frames against the clock: how long to go on, and what their times come to. */
#ifndef APPS_FRAME_TIMING_H
#define APPS_FRAME_TIMING_H

#include "apps/frame/run_statistics.h"

enum { TIMING_MAX_FRAMES = 100000 };

/* When to stop. A first frame that takes half of most_seconds is not followed by others: it stands
 * for all. */
typedef struct TimingPlan {
    double seconds;        /* for so long, */
    uint32_t least_frames; /* and for so many frames, */
    double most_seconds;   /* but for no longer than this */
} TimingPlan;

typedef struct Timing {
    double ms, min_ms, max_ms; /* median, least and greatest wall time */
    double low_ms, high_ms;    /* quartiles: between them lies the middle half of the frames */
    double cpu_ms;             /* mean processor time */
    double idle_ms;            /* mean time that threads had nothing to do, of all together */
    GpPhases phases;           /* sum over the frames */
    uint32_t frames;           /* at least 1 */
} Timing;

/* Draws a list again and again after its first frame.
 * in     frame: as run_first left it; each: room for TIMING_MAX_FRAMES numbers
 * errors those of gp_device_run */
GpResult timing_run(GpDevice *device, const GpList *list, const TimingPlan *plan, double *each,
                    RunStatistics *statistics, Timing *timing, GpError *error);

/* Whether a plan ends after so many frames in so many milliseconds. */
bool timing_is_over(const TimingPlan *plan, uint32_t frames, double spent_ms);

/* Sorts the values. in count: at least 1 */
double timing_median(double *values, size_t count);

#endif
