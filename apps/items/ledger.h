/* The book of a run: which item is whose turn, what has come, and what becomes of it.
 *
 * Items are handed out the longest first, or in their order; results are checked where they are to
 * be, noted in the journal, and taken. Workers are numbers, of threads or of processes.
 */
#ifndef APPS_ITEMS_LEDGER_H
#define APPS_ITEMS_LEDGER_H

#include "apps/items/drawers.h"

enum { LEDGER_LABEL = 96 };

typedef struct Ledger Ledger;

/* Opens the book, and takes what the journal has.
 * in     workers: their number; items of work in order are handed out at most two of each ahead
 * returns the journal's failure, or that to take what it has. owns: the caller, until
 *        ledger_close */
ItemsCode ledger_open(const ItemWork *work, const ItemRun *run, int workers, Ledger **ledger,
                      GpError *error);

/* Closes it; the journal goes where all is done, and stays after a failure.
 * returns `code', which was that of the run, or the failure to end it */
ItemsCode ledger_close(Ledger **ledger, ItemsCode code, GpError *error);

/* What a worker is called in messages: "rank 3 on node7". */
void ledger_name_worker(Ledger *ledger, int worker, const char *label);

/* The next item for a worker; false: there is none for it, now or at all. */
bool ledger_next(Ledger *ledger, int worker, uint32_t *item);

/* The same, from the end: of those that take shortest. */
bool ledger_next_short(Ledger *ledger, int worker, uint32_t *item);

/* What a worker has drawn; takes over drawn->bytes.
 * returns the drawing's failure, with the item and the worker; that to take it; ITEMS_DIFFER */
ItemsCode ledger_put(Ledger *ledger, Drawn *drawn, int worker, GpError *error);

bool ledger_is_done(const Ledger *ledger);

/* returns ITEMS_INTERNAL: an item is out for longer than the run allows */
ItemsCode ledger_look_at_time(const Ledger *ledger, GpError *error);

/* The item that a worker has for longest, by name; false: it has none. */
bool ledger_at(const Ledger *ledger, int worker, char name[ITEM_NAME]);

#endif
