/* What a device tells of the lists it has run: work and time. */
#ifndef GP_COUNTERS_H
#define GP_COUNTERS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Work done since the device was created. */
typedef struct GpCounters {
    uint64_t passes, draws;
    uint64_t vertices;           /* vertices shaded */
    uint64_t primitives;         /* assembled */
    uint64_t primitives_clipped; /* cut by a plane */
    /* pixel shader invocations, helper pixels apart; the fast executor shades only what may be
     * seen */
    uint64_t fragments_shaded;
    /* that waited for others of their pixel; the fast executor's depth test may take some away
     * before */
    uint64_t fragments_sorted;
    uint64_t sorted_slices; /* of tiles, where more waited than there is memory for; fast only */
    /* what follows is counted by the reference executor only */
    uint64_t primitives_drawn; /* that covered at least one pixel */
    uint64_t fragments;        /* pixels covered */
    uint64_t pixels_written;   /* fragments that passed every test */
} GpCounters;

/* Where the time of the last run went, in milliseconds. Fast executor only. */
typedef struct GpPhases {
    double prepare, vertices, bins, tiles; /* by the clock; they follow each other */
    /* inside the tiles, where GpDeviceDesc.timed is set: of all threads together */
    double raster, shading, transfer;
} GpPhases;

#ifdef __cplusplus
}
#endif

#endif
