/* A list run stop by stop: after each draw, or each few where there are many, the targets are as
 * they then were. Bits and order are those of the whole list in one run. */
#ifndef APPS_INSPECT_WALK_H
#define APPS_INSPECT_WALK_H

#include <glasspipe/glasspipe.h>

enum { WALK_MOST_STOPS = 256 };

/* Draws [first, first + count) of a pass. A pass without draws has one stop, for its clear; one
 * with an order by depth one for all, since its fragments wait for its end. */
typedef struct WalkStop {
    uint32_t pass, first, count;
} WalkStop;

/* Who is told: after each stop. returns what the walk shall end with, unless it is GP_OK */
typedef GpResult WalkFn(void *user, const WalkStop *stop, uint32_t number, uint32_t total,
                        GpError *error);

typedef struct Walk {
    const GpList *list;
    GpDevice *device;
    const WalkStop *now; /* of the stop that runs: numbers of a trace's events begin at its first */
    WalkFn *after;
    void *user;
} Walk;

/* Draws so many stops; out, where not NULL: [WALK_MOST_STOPS + passes] */
uint32_t walk_stops(const GpList *list, WalkStop *out);

/* Runs the list. errors those of gp_device_run, of `after`, GP_ERROR_MEMORY */
GpResult walk_run(Walk *walk, GpError *error);

#endif
