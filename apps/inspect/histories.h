/* Whole histories of chosen pixels: every event of the trace, with every value, as JSON.
 *
 * A pixel is {"x", "y", "events": [...]}, an event what trace_json makes of it, without the names
 * of pass, draw and program; those of vertices, clipping and set-up are told once for each
 * primitive, {"draw", "primitive", "vertices": [...], "clip", "setup": [...]}, a vertex with its
 * streams' bytes, "raw", with "reuse", how many elements of the draw name it, and its shader's
 * "steps"; and a "raster" event says in "part" which of its set-ups covered the pixel. "steps" are
 * as steps_json.h has them. Pixels and primitives stand HISTORY_CHUNK a blob. */
#ifndef APPS_INSPECT_HISTORIES_H
#define APPS_INSPECT_HISTORIES_H

#include "apps/inspect/blobs.h"
#include "apps/inspect/fragments.h"
#include "apps/inspect/steps_json.h"
#include "apps/inspect/walk.h"

enum {
    HISTORY_CHUNK = 32,
    HISTORY_STEPS = 24 << 20, /* bytes of a pass's events, beyond which steps are left out */
    HISTORY_MOST = 32 << 20,  /* and all that is about pixels */
};

/* A chosen pixel. */
typedef struct HistoryPixel {
    int32_t x, y;
    Text events; /* JSON texts with commas between */
} HistoryPixel;

/* Those of a pass; a zeroed one is empty, and chooses none. */
typedef struct Histories {
    const GpPass *pass;
    uint32_t width, height;
    uint32_t *number; /* [height][width]: 1 + the pixel's number; 0: not chosen. NULL: none is */
    HistoryPixel *pixel;
    uint32_t count;
    size_t room;
    size_t bytes;      /* of all their events */
    uint32_t left_out; /* events without room */

    uint64_t *asked; /* primitives of chosen pixels, draw << 32 | primitive, ascending */
    size_t asked_count;
    StepListings listings;
    json_t *primitives; /* "draw/primitive": its number */
    json_t *told;       /* [number] */
    json_t *open;       /* the one whose events come in; NULL: none */
    bool open_is_asked; /* it covers a chosen pixel, or is drawn nowhere and is an example of it */
    bool failed;
} Histories;

/* Makes a pass ready. errors GP_ERROR_MEMORY. owns: the caller, until histories_free */
GpResult histories_begin(Histories *histories, const GpPass *pass, GpError *error);

/* Chooses a pixel, if it is inside and was not chosen before. */
void histories_choose(Histories *histories, int32_t x, int32_t y);

/* Notes which primitives are at the chosen pixels, once all are chosen: no others are told of.
 * errors GP_ERROR_MEMORY */
GpResult histories_ask(Histories *histories, const Fragments *fragments, GpError *error);

/* Whether the events of a pixel are wanted. */
static inline bool histories_want(const Histories *histories, int32_t x, int32_t y)
{
    return histories->number && histories->number[(uint32_t)y * histories->width + (uint32_t)x];
}

/* Whether there is room for steps. */
static inline bool histories_want_steps(const Histories *histories)
{
    return histories->bytes <= HISTORY_STEPS;
}

/* Takes an event. in: draw: its number in the pass */
void histories_event(Histories *histories, const GpTraceEvent *event, uint32_t draw);

/* The last primitive has ended. */
void histories_finish(Histories *histories);

/* {"pixels": [[x, y], ...], "blobs": [...], "primitives": {"0/14": 0, ...}, "primitive_blobs":
 * [...], "listings": blob, "left_out": events} */
json_t *histories_tell(const Histories *histories, Blobs *blobs);

void histories_free(Histories *histories);

#endif
