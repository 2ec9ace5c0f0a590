/* The floor of a frame: the time below which this machine cannot draw it, whoever does it. */
#ifndef APPS_BENCH_FLOOR_H
#define APPS_BENCH_FLOOR_H

#include "apps/bench/rates.h"

/* Milliseconds, of all threads together. What a processor computes it computes one after the other;
 * memory is moved meanwhile: ms = max(operations_ms + triangles_ms, traffic_ms). */
typedef struct BenchFloor {
    double operations_ms; /* of vertices and fragments shaded, by the cheapest draw of each pass */
    double triangles_ms;  /* of those that cover a pixel */
    /* targets, vertices and indices once a pass; of textures what there is, or a texel a fragment
     * if that is less */
    double traffic_ms;
    double ms;
} BenchFloor;

/* Finds it by running each pass once more by itself, and all of them once by the reference executor
 * where triangles are many and fragments few: which triangles are drawn only that one tells;
 * elsewhere all count.
 * in   list: was run before, and is not looked at any more: what its targets hold is lost
 * errors those of gp_device_run */
GpResult bench_floor_find(GpDevice *device, const BenchRates *rates, const GpList *list,
                          BenchFloor *floor, GpError *error);

#endif
