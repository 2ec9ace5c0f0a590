/* Running a list with a clock at hand; what it took, and what the device counted. */
#ifndef APPS_FRAME_RUN_STATISTICS_H
#define APPS_FRAME_RUN_STATISTICS_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

/* Times in milliseconds, and what the device did for one frame. */
typedef struct RunStatistics {
    double first_ms; /* the first frame, which also touches all memory for the first time */
    double first_cpu_ms;
    double ms, cpu_ms; /* a later one: wall clock, and processor time of all threads; 0: not run */
    GpCounters counters;
    GpPhases phases; /* of the last frame */
    const char *isa;
    GpExecutor executor;
    int threads;
} RunStatistics;

/* Runs a list for the first time. Errors: those of gp_device_run. */
GpResult run_first(GpDevice *device, const GpList *list, RunStatistics *statistics, GpError *error);

/* Runs it again, for the clock. A list that does not clear its targets draws over its first frame:
 * hash and write the picture before. */
GpResult run_again(GpDevice *device, const GpList *list, RunStatistics *statistics, GpError *error);

/* Sets what the device counted in the first frame. */
void run_add_counters(const RunStatistics *statistics, json_t *object);

/* All of it as JSON, with the hash and size of its picture. The caller owns it. */
json_t *run_json(const RunStatistics *statistics, uint64_t hash, const GpSurface *surface);

#endif
