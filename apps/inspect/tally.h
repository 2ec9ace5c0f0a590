/* Counters of a stop: how many came to each stage, and what became of the rest. */
#ifndef APPS_INSPECT_TALLY_H
#define APPS_INSPECT_TALLY_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

typedef enum TallyKind {
    TALLY_VERTICES, /* shaded */
    TALLY_PRIMITIVES,
    TALLY_OUTSIDE, /* clipped away whole */
    TALLY_CUT,     /* by a plane, and something is left */
    TALLY_FACING,  /* culled; of what is left of a cut triangle each part counts */
    TALLY_ZERO_AREA,
    TALLY_NO_CENTER, /* holds no pixel centre */
    TALLY_DRAWN,     /* covers a pixel */
    TALLY_FRAGMENTS,
    TALLY_KILLED,
    TALLY_CLIP_PLANE,
    TALLY_SCISSOR,
    TALLY_ALPHA,
    TALLY_STENCIL,
    TALLY_DEPTH,
    TALLY_WRITTEN,
    TALLY_KINDS
} TallyKind;

typedef struct Tally {
    uint64_t count[TALLY_KINDS];
    GpCounters before; /* of the device, when the stop began */
} Tally;

/* A stop begins. */
void tally_begin(Tally *tally, const GpDevice *device);

/* Takes an event of a run that tells of all pixels. */
void tally_event(Tally *tally, const GpTraceEvent *event);

/* The stop has ended: what the device counts itself. */
void tally_end(Tally *tally, const GpDevice *device);

/* {"vertices": .., ...} The caller owns it. */
json_t *tally_tell(const Tally *tally);

#endif
