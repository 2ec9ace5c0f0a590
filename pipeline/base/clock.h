/* The clock of the phases. */
#ifndef GP_FAST_CLOCK_H
#define GP_FAST_CLOCK_H

#include <time.h>

static inline double fast_clock_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

/* Milliseconds since *mark, which becomes now. */
static inline double fast_clock_lap(double *mark)
{
    double before = *mark;
    *mark = fast_clock_ms();
    return *mark - before;
}

#endif
