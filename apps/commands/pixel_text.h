/* The history of one pixel as text, told from the reference executor's trace. */
#ifndef APPS_COMMANDS_PIXEL_TEXT_H
#define APPS_COMMANDS_PIXEL_TEXT_H

#include <glasspipe/glasspipe.h>

#include <stdio.h>

/* Text: numbers with six digits, one block a fragment. */
typedef struct PixelText {
    FILE *file;
    bool color; /* verdicts in colour */
    const GpList *list;
    GpTraceKind last;           /* private from here on: the previous event's kind */
    bool any_pass, in_fragment; /* something was printed; a fragment's block is open */
    uint32_t pass;              /* of the previous event */
    uint32_t fragments, stored, rejected, missed;
    bool alive; /* the open fragment has failed no test */
    bool waits; /* and it has its turn later */
} PixelText;

/* Prints one event of the list's run. Events come in the trace's order. */
void pixel_text_event(PixelText *history, const GpTraceEvent *event);

/* Ends the last block and sums up. */
void pixel_text_end(PixelText *history);

#endif
