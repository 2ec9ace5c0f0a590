#include "apps/commands/progress.h"

#include "apps/base/machine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A terminal on which a line can be wiped. */
static bool can_wipe(void)
{
    const char *term = getenv("TERM");
    return isatty(STDERR_FILENO) && term && strcmp(term, "dumb") != 0;
}

Progress progress_begin(const Options *options)
{
    return (Progress){ options, machine_clock_ms(CLOCK_MONOTONIC) };
}

void progress_tell(const void *user, uint32_t done, uint32_t total, const char *text)
{
    const Progress *progress = user;
    const bool is_long = machine_clock_ms(CLOCK_MONOTONIC) - progress->start_ms > 1000;
    if (progress->options->quiet || !is_long || !can_wipe())
        return;
    fputs("\r\033[K", stderr);
    if (done == total)
        return;
    fprintf(stderr, "%u/%u ", done + 1, total);
    message_print(stderr, text);
}
