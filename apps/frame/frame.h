/* The work of a frame: a list of passes and everything it refers to, built once and run again and
 * again. What benchmark cases and techniques are made with.
 *
 * Memory that runs short ends the program (exit code 4): nobody has anything better to do. What
 * depends on the user's files is checked before and fails in the usual way.
 */
#ifndef APPS_FRAME_FRAME_H
#define APPS_FRAME_FRAME_H

#include "pipeline/glasspipe.h"

enum {
    FRAME_MAX_BLOCKS = 1024,
    FRAME_MAX_SURFACES = 64,
};

/* A zeroed one is empty. Owned by whoever made it, until frame_free. */
typedef struct Frame {
    GpList list;
    GpSurface *color; /* the picture, whose alpha may be a measure of its own; NULL: depth is */
    GpSurface *depth; /* the picture's depth buffer, NULL: none */
    const void
        *made; /* what the technique has to say of its frame, in its own struct; NULL: nothing */

    /* private */
    GpPass *passes;
    GpDraw *draws;
    uint32_t pass_room, draw_count, draw_room;
    void *blocks[FRAME_MAX_BLOCKS];
    GpSurface *surfaces[FRAME_MAX_SURFACES];
    int block_count, surface_count;
} Frame;

/* Frees all that was made for it, and zeroes it; a zeroed one is fine. */
void frame_free(Frame *frame);

/* --- memory and surfaces: belong to the work until frame_free --------------------------------- */

void *frame_alloc(Frame *frame, size_t count, size_t size); /* zeroed */
const void *frame_copy(Frame *frame, const void *data, size_t size);
GpSurface *frame_surface(Frame *frame, GpFormat format, uint32_t width, uint32_t height,
                         uint32_t levels);

/* --- passes ---------------------------------------------------------------------------------- */

/* Makes room for a list; to be called once, before the first pass. */
void frame_reserve(Frame *frame, uint32_t passes, uint32_t draws);

/* Appends a pass, then draws to the last one. color, NULL for none, is cleared to clear_color;
 * depth, NULL for none, to 1. The struct returned is the list's own, for what is to be different. */
GpPass *frame_pass(Frame *frame, const char *name, GpSurface *color, GpSurface *depth,
                   const float clear_color[4]);
GpDraw *frame_draw(Frame *frame, const GpProgram *program, const void *uniforms,
                   const GpGeometry *geometry);

#endif
