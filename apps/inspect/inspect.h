/* A frame as one page of HTML, to be walked through stage by stage: what was drawn, what every unit
 * saw and decided, and the history of every pixel.
 *
 * The data of a page are blobs (blobs.h). The last one is the frame, as JSON:
 *
 *   title, technique, width, height   of the picture
 *   picture                number of its surface, or -1
 *   surfaces               targets_tell
 *   verdicts               names of FragmentVerdict
 *   passes[]               pass, name, width, height, order, group
 *     targets[]            slot ("0" .. "3", "depth"), surface, clear: null, or cleared to what
 *     draws[]              draw, name, program, geometry, primitives, vertices; units[] (unit,
 *                          runs, why); state {words}; uniforms[], textures[]; costs of its shaders
 *     stops[]              first, count of draws; targets[] (targets_changed); counters {words}
 *     fragments, lod       blobs (fragments.h); fragments_left_out: how many have no place in it
 *     histories            histories_tell
 *   differing              pixels that differ from the picture beside it; null: none is, or it is
 *                          of another size or format
 *   truth                  null, or off (blob of floats, InspectTruth.off), over, under, how
 *   grid, region, dense    what was chosen to be recorded whole; share: the part of it that had
 *                          room
 *   sources, programs      sources_tell (blob), sources_of_programs
 *
 * A lesson has one more blob, lesson_tell's.
 *
 * The element "timings" is beside them: milliseconds by phase of the fast executor, and not there
 * with no_timings. A page that compares has two frames.
 */
#ifndef APPS_INSPECT_INSPECT_H
#define APPS_INSPECT_INSPECT_H

#include "apps/base/text.h"
#include "apps/inspect/lesson.h"
#include <glasspipe/glasspipe.h>

/* How far a picture is from the exact one. */
typedef struct InspectTruth {
    /* [height][width] of the picture: above it, or below; 0: as it should be. NULL: unknown */
    const float *off;
    const char *over, *under; /* what that means: "lit where the truth is dark, a leak" */
    const char *how;          /* the exact one was found: sentences */
} InspectTruth;

typedef struct Inspect {
    const char *title, *about; /* about: a sentence or NULL */
    const char *technique;     /* whose frame it is, for panels of its own; NULL: a scene's */
    const GpList *list;
    const GpSurface *picture; /* the target to look at first; NULL: the last pass's */
    /* a picture drawn before, to count the pixels that differ; NULL: none */
    const GpSurface *beside;
    InspectTruth truth;
    GpRect region;   /* recorded whole, in passes of the picture's size; empty: none */
    int32_t draw;    /* whose pixels are recorded more densely; -1: none */
    uint32_t pixels; /* to be recorded whole, about so many a pass; 0: a default */
    /* a question to be answered before the page shows its value; NULL: none */
    const Lesson *lesson;
    bool no_timings;
    int threads;
    const char *isa; /* of the fast executor; NULL: automatic */
    /* Hears how far the work is. NULL: nobody does */
    void (*progress)(const void *user, uint32_t done, uint32_t total, const char *text);
    const void *user;
} Inspect;

/* Makes the page.
 * in   against: another frame, to be compared with; NULL: none
 * errors those of gp_device_run and lesson_tell; GP_ERROR_UNSUPPORTED: both executors differ;
 *      GP_ERROR_MEMORY
 * owns: the caller, until text_free */
GpResult inspect_page(const Inspect *inspect, const Inspect *against, Text *page, GpError *error);

#endif
