/* Frames of a scene, whole or window by window, as items that anyone draws to bytes. */
#ifndef APPS_COMMANDS_RENDER_FRAMES_H
#define APPS_COMMANDS_RENDER_FRAMES_H

#include "apps/frame/strips.h"
#include "apps/items/items.h"
#include "apps/scene/path.h"
#include "apps/scene/scene.h"

enum { FRAMES_PATH = 4096 };

typedef struct FrameResult {
    GpFormat format;
    uint32_t width, height;
    uint32_t none; /* there is no gap: its bytes are told to others */
    uint64_t hash; /* gp_surface_hash's */
} FrameResult;

/* Frame number i is first + i * step; its window is cut into parts, of each of which an item is
 * made. */
typedef struct Frames {
    const char *scene, *output; /* paths; # of the output are digits of the frame */
    bool moves;                 /* there are frames, and not just one picture */
    ScenePath path;             /* empty: none */
    uint32_t turn;              /* frames of a full turn; 0: none */
    uint32_t first, step, count;
    uint32_t whole[2]; /* pixels of the picture */
    GpRect window;     /* of it, that is to be drawn */

    /* frames_split's */
    uint32_t part[2];       /* pixels of a part, but at the window's edges */
    uint32_t columns, rows; /* parts of a frame */
    bool in_strips;         /* the window is too large to be in memory */
    FrameResult *results;   /* [count] */

    /* private */
    GpSurface **pictures; /* [count], of parts that have come; NULL: none, or all */
    uint32_t *missing;    /* [count] parts */
    Strips *strips;
    char strips_path[FRAMES_PATH];
} Frames;

/* Cuts frames into so many parts that there is work for all who draw at once, and that each fits
 * into memory.
 * errors GP_ERROR_INVALID: too large for the output's format; GP_ERROR_MEMORY */
GpResult frames_split(Frames *frames, uint32_t at_once, GpError *error);

ItemWork frames_work(Frames *frames);

uint32_t frames_number(const Frames *frames, uint32_t i);
void frames_file(const Frames *frames, uint32_t i, char path[FRAMES_PATH]);

void frames_free(Frames *frames); /* zeroes it */

#endif
