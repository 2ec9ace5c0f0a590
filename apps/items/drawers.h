/* Threads that draw items, each with a device of its own. */
#ifndef APPS_ITEMS_DRAWERS_H
#define APPS_ITEMS_DRAWERS_H

#include "apps/items/items.h"

typedef struct Drawers Drawers;

/* An item that was drawn, or was not. */
typedef struct Drawn {
    uint32_t item;
    int drawer;
    GpResult result;
    GpError error; /* its reason */
    char *bytes;   /* owned by whoever asked for it: gp_free */
    size_t size, same;
} Drawn;

/* Starts threads; each makes its device of so many threads. Where memory ends, `least' of them will
 * do.
 * returns ITEMS_USAGE: there is no such device here; owns: the caller, until drawers_stop */
ItemsCode drawers_start(const ItemWork *work, const GpDeviceDesc *device, uint32_t count,
                        uint32_t least, uint32_t threads_each, Drawers **drawers, GpError *error);

/* Ends them when they have drawn what they have. NULL-safe, sets NULL.
 * in     wait: until then; else those at work go on alone, with what the work reads, until the
 *        process ends */
void drawers_stop(Drawers **drawers, bool wait);

/* The first thread from `from' on that has nothing to do, or -1. */
int drawers_find_free(Drawers *drawers, int from);

/* Gives it an item. */
void drawers_give(Drawers *drawers, int drawer, uint32_t item);

/* Waits so many seconds at most for an item to be drawn, whichever is first; false: none was. */
bool drawers_wait(Drawers *drawers, double seconds, Drawn *drawn);

#endif
