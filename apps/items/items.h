/* Work that can be split: a list of items, each drawn to bytes by anyone, and taken in one place.
 *
 * A command says what its items are, and nothing of who draws them. Here threads do, each with a
 * device of its own; the program `glasspipe-mpi' puts its runner in their place, which lets other
 * processes draw, on this machine or on others. What an item is drawn to depends on nothing but the
 * item, so that all of them give the same.
 */
#ifndef APPS_ITEMS_ITEMS_H
#define APPS_ITEMS_ITEMS_H

#include "pipeline/base/pool.h"
#include "pipeline/io/bytes.h"
#include <glasspipe/glasspipe.h>

enum { ITEM_NAME = 96 };

/* What a run comes to: the program's exit codes. */
typedef enum ItemsCode {
    ITEMS_DONE = 0,
    ITEMS_DIFFER = 1, /* two drawings of an item */
    ITEMS_USAGE = 2,  /* the device that is asked for is not here */
    ITEMS_INPUT =
        3, /* an item could not be drawn from what there is; or the journal is of other work */
    ITEMS_INTERNAL = 4, /* no memory, a result that could not be taken, an item that never came */
} ItemsCode;

/* What draws one item at a time: belongs to one thread. */
typedef struct ItemTools {
    GpDevice *device;
    GpPool *pool; /* of as many threads as the device */
} ItemTools;

/* A list of items. `context' is the command's own; what `draw' and `tell' read of it is made
 * before, from the command's arguments and files alone, so that every process has the same. */
typedef struct ItemWork {
    uint32_t count;
    bool in_order; /* items are taken in their order, else as they come */
    /* times are part of what is drawn: here one item is drawn at a time, by all threads, and so is
     * one that is drawn twice */
    bool measures;
    void *context;

    /* What it is for people: "frame 12". */
    void (*tell)(const void *context, uint32_t item, char name[ITEM_NAME]);

    /* How long it takes, in any unit, beside the others. NULL: all alike. */
    double (*cost)(const void *context, uint32_t item);

    /* Appends the item to `bytes', in any thread of any process.
     * out    same: of these so many come out the same whenever the item is drawn; as they are: all
     * errors any; the message begins with what the item is drawn from */
    GpResult (*draw)(const void *context, uint32_t item, const ItemTools *tools, GpBytes *bytes,
                     size_t *same, GpError *error);

    /* Takes what was drawn, in the thread that called items_run, of the first process. */
    GpResult (*take)(void *context, uint32_t item, const void *bytes, size_t size, GpError *error);
} ItemWork;

/* How it is run. */
typedef struct ItemRun {
    GpDeviceDesc device; /* threads: of all devices of a process together; 0: all processors */
    double verify;       /* per cent of the items that are drawn twice, by different threads */
    double timeout;      /* seconds that an item may take; 0: any */
    const char *journal; /* file that notes what was taken, removed when all was; NULL: none */
    bool resume;         /* goes on from it where it is there; else here none is kept */
    uint64_t key;        /* of the work: a journal of other work is refused */
    void (*progress)(const void *user, uint32_t done, uint32_t total, const char *name);
    const void *user; /* of progress */

    /* Ends the process with a message, where an item never ends: it reads what the caller would
     * free. NULL: items_run returns all the same, for callers who free nothing. */
    void (*end)(int code, const char *line);
} ItemRun;

/* Runs all items. What was taken before a failure stays.
 * out    error: why, where it is not ITEMS_DONE */
ItemsCode items_run(const ItemWork *work, const ItemRun *run, GpError *error);

/* What a failure to draw comes to. */
static inline ItemsCode items_code(GpResult result)
{
    return !result                          ? ITEMS_DONE
           : result == GP_ERROR_MEMORY      ? ITEMS_INTERNAL
           : result == GP_ERROR_UNSUPPORTED ? ITEMS_USAGE
                                            : ITEMS_INPUT;
}

/* Items that are drawn at once, at most: what work should be split into. The same in all
 * processes. */
uint32_t items_at_once(const ItemRun *run);

/* --- who runs them ---------------------------------------------------------------------------- */

typedef struct ItemRunner {
    ItemsCode (*run)(const ItemWork *work, const ItemRun *run, GpError *error);
    uint32_t (*at_once)(const ItemRun *run);
    uint32_t threads; /* of this process, where the device says none */
} ItemRunner;

/* Puts another in the place of this process's threads; NULL: these. Before any items_run. */
void items_set_runner(const ItemRunner *runner);

/* Whether other processes draw too. */
bool items_are_shared(void);

/* Threads that a process has for items. */
uint32_t items_threads(const ItemRun *run);

#endif
