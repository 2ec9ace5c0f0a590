/* Quads of a pass's targets as they were before they were drawn on, so that this can be undone. */
#ifndef GP_HELD_QUADS_H
#define GP_HELD_QUADS_H

#include "pipeline/list/list.h"

typedef struct GpHeldQuads {
    const GpPass *pass;
    uint32_t quads_x; /* in a row */
    uint8_t *seen;    /* [quads_y][quads_x]: 1 where one is held */
    uint8_t *held;    /* one after the other: its place, then [target][2][2] texels */
    size_t bytes;     /* of each */
    size_t count, room;
    bool failed; /* for want of memory some are not there */
} GpHeldQuads;

/* Makes ready for a pass. errors GP_ERROR_MEMORY. owns: the caller, until gp_held_free, also
 * then */
GpResult gp_held_begin(GpHeldQuads *quads, const GpPass *pass, GpError *error);

/* Holds the quad whose first pixel is (x, y), unless it is held. */
void gp_held_add(GpHeldQuads *quads, int32_t x, int32_t y);

/* Puts back what they hold. */
void gp_held_put(const GpHeldQuads *quads);

void gp_held_free(GpHeldQuads *quads); /* zeroes it */

#endif
