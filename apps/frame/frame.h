/* A frame: a list of passes and everything it refers to, built once and run again and again. What
 * scenes, benchmark cases and techniques are made with.
 *
 * Memory that runs short marks the frame, and building goes on: passes, draws, copies and surfaces
 * may be asked for and set as before. Only what frame_alloc gives, and the texels of a surface, are
 * then not there, so that who writes to them looks first. Builders end by asking frame_result.
 */
#ifndef APPS_FRAME_FRAME_H
#define APPS_FRAME_FRAME_H

#include "apps/frame/arena.h"
#include <glasspipe/glasspipe.h>

/* A zeroed one is empty. Owned by whoever made it, until frame_free. */
typedef struct Frame {
    GpList list;
    GpSurface *color; /* the picture, whose alpha may be a measure of its own; NULL: depth is */
    GpSurface *depth; /* the picture's depth buffer, NULL: none */
    const void *made; /* what the technique has to say of its frame, in its own struct; or NULL */
    Arena arena;      /* all that the list refers to, */
    void *held; /* but for what something else made, which frame_free gives to release; or NULL */
    void (*release)(void *held);

    /* The part that is to be drawn of a picture of this size, as GpSurfaceDesc.window; all zero:
     * all of it */
    GpRect window;
    uint32_t window_of[2];

    /* private */
    GpPass *passes;
    GpDraw *draws; /* of all passes, in order */
    uint32_t pass_room, draw_count, draw_room;
    GpPass no_pass; /* what is asked for without memory */
    GpDraw no_draw;
    GpSurface no_surface;
} Frame;

/* Frees all that was made for it, and zeroes it; a zeroed one is fine. */
void frame_free(Frame *frame);

/* What a frame shows: its colour, or its depth where it has none. */
static inline GpSurface *frame_picture(const Frame *frame)
{
    return frame->color ? frame->color : frame->depth;
}

/* Whether all memory was there. errors GP_ERROR_MEMORY */
GpResult frame_result(const Frame *frame, GpError *error);

/* Memory that is not its own was missing for what it draws: its result says so. */
void frame_fail(Frame *frame);

/* --- memory and surfaces: belong to the frame until frame_free -------------------------------- */

void *frame_alloc(Frame *frame, size_t count, size_t size); /* zeroed; NULL: out of memory */
const void *frame_copy(Frame *frame, const void *data, size_t size);
void *frame_own(Frame *frame, void *memory); /* of gp_alloc; NULL: none, or out of memory */

/* Never NULL; without memory its texels are. */
GpSurface *frame_surface(Frame *frame, GpFormat format, uint32_t width, uint32_t height,
                         uint32_t levels);

/* The same with one level, for what is drawn pixel by pixel: where it is of the picture's size, it
 * has the frame's window. */
GpSurface *frame_target(Frame *frame, GpFormat format, uint32_t width, uint32_t height);

/* --- passes ----------------------------------------------------------------------------------- */

/* Appends a pass, then draws to the last one. color, NULL for none, is cleared to clear_color;
 * depth, NULL for none, to 1. The struct returned is the list's own, for what is to be different,
 * and stays where it is until the next pass, or the next draw. */
GpPass *frame_pass(Frame *frame, const char *name, GpSurface *color, GpSurface *depth,
                   const float clear_color[4]);
GpDraw *frame_draw(Frame *frame, const GpProgram *program, const void *uniforms,
                   const GpGeometry *geometry);

/* The same with a copy of the uniforms. */
GpDraw *frame_draw_copied(Frame *frame, const GpProgram *program, const void *uniforms,
                          const GpGeometry *geometry);

/* Takes draws out of the last pass; the others keep their order.
 * out    taken: [draws of the pass], in order
 * returns how many */
uint32_t frame_take(Frame *frame, bool (*which)(const GpDraw *draw), GpDraw *taken);

/* Makes room for so many more draws at once, of which there are millions: otherwise their array
 * moves as it grows, and leaves what it was behind. */
void frame_reserve(Frame *frame, uint32_t draws);

#endif
