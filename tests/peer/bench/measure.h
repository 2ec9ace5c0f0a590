/* Timing the frames of a case. */
#ifndef PEER_BENCH_MEASURE_H
#define PEER_BENCH_MEASURE_H

#include "tests/peer/bench/replay.h"

typedef struct PeerTiming {
    double ms, min_ms; /* of one frame: the median and the least */
    double cpu_ms;     /* of one frame, over all threads of the process */
    double first_ms;   /* the first frame, which compiles */
    double others; /* processors that other processes kept busy meanwhile; negative: not known */
    uint32_t frames;
} PeerTiming;

/* Draws the first frame, up to three more that are not timed, and then frames for so many seconds,
 * at least 20 if those fit into twice the time, and at least one. A frame ends when the driver has
 * finished it. */
PeerTiming measure(Replay *replay, double seconds);

#endif
