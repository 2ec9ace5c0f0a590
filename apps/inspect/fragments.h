/* Every fragment of a frame in a word or two: which triangle of which draw, and what became of it.
 *
 * A pass becomes one blob: pixels in rows from the top, those beside each other with equal
 * fragments put together. Of each run: how many pixels; how many fragments; and of each fragment
 * its draw, its primitive, and its verdict (FragmentVerdict), plus 16 where it shows its front. All
 * are unsigned numbers in bytes of seven bits, the lowest first, the eighth set where more follow
 * (LEB128). */
#ifndef APPS_INSPECT_FRAGMENTS_H
#define APPS_INSPECT_FRAGMENTS_H

#include "apps/inspect/blobs.h"
#include "apps/inspect/walk.h"

typedef enum FragmentVerdict {
    FRAGMENT_WRITTEN,
    FRAGMENT_HIDDEN, /* written, and later replaced without being read */
    FRAGMENT_KILLED, /* by its shader */
    FRAGMENT_CLIP_PLANE,
    FRAGMENT_SCISSOR,
    FRAGMENT_ALPHA,
    FRAGMENT_STENCIL,
    FRAGMENT_DEPTH,
    /* no fragment: the triangle was culled by its facing, and would have covered it */
    FRAGMENT_CULLED,
    FRAGMENT_CLIPPED, /* nor is this: only the near or the far plane cut it away here */
    FRAGMENT_VERDICTS
} FragmentVerdict;

/* By value: "depth test". */
extern const char *const fragment_verdict_names[FRAGMENT_VERDICTS];

typedef struct Fragment {
    uint32_t pixel, sequence, draw, primitive; /* y * width + x; order of output */
    uint8_t verdict;
    bool front;
    bool replaces; /* what was there is not read */
} Fragment;

/* Those of a pass; a zeroed one is empty. */
typedef struct Fragments {
    Fragment *all;
    size_t count, room, most;
    uint32_t width, height;
    /* [height][width]: 128 + 16 times the level of detail of the last texture read of the pixel,
     * within 1 and 255; 0: none. NULL: not asked for */
    uint8_t *lod;
    uint32_t left_out; /* for there were more than `most` */
    size_t latest[4];  /* 1 + the number of the last one at each place of a quad; 0: none */
    uint32_t sequence;
    bool failed;
} Fragments;

/* Takes what an event tells of a fragment; others are of no concern. in: draw: its number in the
 * pass */
void fragments_event(Fragments *fragments, const GpPass *pass, const GpTraceEvent *event,
                     uint32_t draw);

/* Sorts them by pixel, and each pixel's by turn, and finds those that are hidden. After all
 * events. */
void fragments_finish(Fragments *fragments);

/* The blob of a pass, finished; BLOB_NONE where memory is short. */
int fragments_blob(const Fragments *fragments, Blobs *blobs);

/* The levels of detail as one blob, as they are; BLOB_NONE where no texture was read. */
int fragments_lod_blob(const Fragments *fragments, Blobs *blobs);

void fragments_free(Fragments *fragments);

#endif
