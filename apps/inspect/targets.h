/* What the targets of a frame held after each stop of its walk, as blobs of differences.
 *
 * A blob holds one state of one surface: the bytes of its texels, exclusive-or with the state
 * before (before the frame), row 0 at the top; byte by byte of a texel in planes of their own,
 * [bytes of a texel][height][width]; and along each row of a plane the difference to the byte
 * before, modulo 256. So what did not change, and what changes evenly, is nearly nothing when
 * packed. */
#ifndef APPS_INSPECT_TARGETS_H
#define APPS_INSPECT_TARGETS_H

#include "apps/inspect/blobs.h"
#include "apps/inspect/walk.h"

#include <jansson.h>

/* A surface that some pass draws to. */
typedef struct TargetState {
    const GpSurface *surface;
    uint8_t *initial, *before, *now, *planes; /* bytes of all texels; initial: before the frame */
} TargetState;

/* A zeroed one is empty. */
typedef struct Targets {
    TargetState *state;
    uint32_t count;
} Targets;

/* Finds the surfaces, each once, and keeps what they hold. errors GP_ERROR_MEMORY. owns: the
 * caller, until targets_free */
GpResult targets_find(const GpList *list, Targets *targets, GpError *error);
void targets_free(Targets *targets);

/* The number of a surface among them, or -1. */
int targets_number(const Targets *targets, const GpSurface *surface);

/* [{"surface": 0, "blob": 3, "ranges": ranges_tell}, ...] of the surfaces of a pass that have
 * changed since they were last asked for. The ranges are there once the errands of the blobs are
 * done. The caller owns it. */
json_t *targets_changed(Targets *targets, const GpPass *pass, Blobs *blobs);

/* [{"name", "format", "width", "height", "bytes" (of a texel), "depth", "initial", "ranges"}, ...]
 * of all, by number. initial: the blob of what they held before the frame, against zeros; null:
 * zeros. */
json_t *targets_tell(const Targets *targets, const GpList *list, Blobs *blobs);

/* Puts back what the surfaces held before the frame. */
void targets_restore(const Targets *targets);

/* The first surface that does not hold what it held when it was last asked for; NULL: all do. */
const GpSurface *targets_differ(Targets *targets);

#endif
