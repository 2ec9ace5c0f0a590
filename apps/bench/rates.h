/* What this machine can do at most, measured: arithmetic, triangles, bytes. */
#ifndef APPS_BENCH_RATES_H
#define APPS_BENCH_RATES_H

#include <glasspipe/glasspipe.h>

typedef struct BenchRates {
    double operations; /* of one component, a millisecond: independent ones, out of registers */
    /* a millisecond: from indices to one pixel's depth, all else in the nearest cache */
    double triangles;
} BenchRates;

/* Measures a device, all threads together, in about a third of a second.
 * errors those of gp_device_run */
GpResult bench_rates_measure(GpDevice *device, BenchRates *rates, GpError *error);

/* Milliseconds in which so many threads read and write so many bytes that lie where those of a
 * frame lie that is drawn again and again: in the nearest caches that hold all of them.
 * errors GP_ERROR_MEMORY */
GpResult bench_traffic_ms(int threads, size_t read, size_t written, double *ms, GpError *error);

#endif
