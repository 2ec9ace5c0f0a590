/* What was drawn, in a file, so that a run that was ended can go on.
 *
 * A line of text, the key of the work, and of each item its number, size, hash and bytes, one after
 * the other as they came. A last one that is not whole counts as not drawn. Integers have the
 * machine's byte order: it is read where it was written.
 */
#ifndef APPS_ITEMS_JOURNAL_H
#define APPS_ITEMS_JOURNAL_H

#include "pipeline/base/base.h"

#include <stdio.h>

typedef struct Journal {
    FILE *file; /* NULL: none */
    const char *path;
} Journal;

/* Opens it for what is to come, after what is there already, or empty.
 * in     resume: what is there is read, and given to `put' in its order, which owns the bytes
 * errors GP_ERROR_IO; GP_ERROR_FORMAT: no journal, or that of other work; put's */
GpResult journal_open(const char *path, uint64_t key, bool resume,
                      GpResult (*put)(void *context, uint32_t item, char *bytes, size_t size,
                                      GpError *error),
                      void *context, Journal *journal, GpError *error);

/* Adds an item, and makes sure that it is out of this process's hands. errors GP_ERROR_IO */
GpResult journal_add(const Journal *journal, uint32_t item, const void *bytes, size_t size,
                     GpError *error);

/* Closes it, and removes the file of work that is done. A zeroed one is fine. errors GP_ERROR_IO */
GpResult journal_close(Journal *journal, bool done, GpError *error);

#endif
