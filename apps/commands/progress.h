/* How far a long work is: a line on a terminal, which is written again and again. */
#ifndef APPS_COMMANDS_PROGRESS_H
#define APPS_COMMANDS_PROGRESS_H

#include "apps/commands/options.h"

typedef struct Progress {
    const Options *options; /* --quiet: nothing is said */
    double start_ms;
} Progress;

/* Of work that begins now. */
Progress progress_begin(const Options *options);

/* As a ChartListener's progress: nothing in the first second; all done wipes the line. */
void progress_tell(const void *progress, uint32_t done, uint32_t total, const char *text);

#endif
