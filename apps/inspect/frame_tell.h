/* What a frame says of itself, before it is run: passes, draws, what each needs, its state. */
#ifndef APPS_INSPECT_FRAME_TELL_H
#define APPS_INSPECT_FRAME_TELL_H

#include "apps/inspect/targets.h"

/* A pass as inspect.h has it: pass, name, width, height, order, group, targets, draws.
 * in   draws: how many of them are told; the others are as many as its "draw_count" says */
json_t *frame_tell_pass(const GpList *list, uint32_t pass, uint32_t group, uint32_t draws,
                        const Targets *targets);

/* [{"slot", "name", "format", "width", "height", "levels", "min", ...}, ...] of the textures that
 * are bound. The caller owns it. */
json_t *frame_tell_textures(const GpDraw *draw);

#endif
