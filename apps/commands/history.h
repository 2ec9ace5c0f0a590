/* The history of one pixel, told from the reference executor's trace: as text for a person, or as
 * JSON for a program. */
#ifndef APPS_COMMANDS_HISTORY_H
#define APPS_COMMANDS_HISTORY_H

#include "pipeline/glasspipe.h"

#include <jansson.h>
#include <stdio.h>

/* Text: numbers with six digits, one block a fragment. */
typedef struct HistoryText {
    FILE *file;
    bool color; /* verdicts in colour */
    const GpList *list;
    GpTraceKind last;           /* private from here on: the previous event's kind */
    bool any_pass, in_fragment; /* something was printed; a fragment's block is open */
    uint32_t pass;              /* of the previous event */
    uint32_t fragments, stored, rejected;
    bool alive; /* the open fragment has failed no test */
} HistoryText;

/* Prints one event of the list's run. Events come in the trace's order. */
void history_text_event(HistoryText *history, const GpTraceEvent *event);

/* Ends the last block and sums up. */
void history_text_end(HistoryText *history);

/* The same event as an object: kind, pass, draw, primitive, names, and the members of the event's
 * struct in pipeline/list/trace.h under their own names. The caller owns it. */
json_t *history_json_event(const GpTraceEvent *event);

#endif
