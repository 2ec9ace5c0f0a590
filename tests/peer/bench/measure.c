/* Wall time, the process's own CPU time, and how much the rest of the machine was in the way. */
#include "tests/peer/bench/measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { MOST_FRAMES = 20000, ENOUGH_FRAMES = 20, WARM_FRAMES = 3 };

/* Read together, so that they can be subtracted. */
typedef struct Clocks {
    double wall, own, machine; /* seconds; CPU seconds of this process, of all; machine < 0: none */
} Clocks;

static double seconds_of(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static Clocks read_clocks(void)
{
    Clocks c = { .wall = seconds_of(CLOCK_MONOTONIC), .own = seconds_of(CLOCK_PROCESS_CPUTIME_ID) };
    double user, nice, system, idle, wait, irq, softirq, steal;
    FILE *file = fopen("/proc/stat", "r");
    if (file && fscanf(file, "cpu %lf %lf %lf %lf %lf %lf %lf %lf", &user, &nice, &system, &idle,
                       &wait, &irq, &softirq, &steal) == 8)
        c.machine = (user + nice + system + irq + softirq + steal) / (double)sysconf(_SC_CLK_TCK);
    else
        c.machine = -1;
    if (file)
        fclose(file);
    return c;
}

static double draw_frame(Replay *replay)
{
    double start = seconds_of(CLOCK_MONOTONIC);
    replay_frame(replay);
    return seconds_of(CLOCK_MONOTONIC) - start;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, compare_doubles);
    return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

Timing measure(Replay *replay, double seconds)
{
    Timing timing = { .first_ms = 1e3 * draw_frame(replay) };
    double frames[MOST_FRAMES], spent = 0;
    for (int i = 0; i < WARM_FRAMES && spent < seconds / 2; i++)
        spent += draw_frame(replay);
    Clocks start = read_clocks();
    int n = 0;
    spent = 0;
    do
        spent += frames[n++] = draw_frame(replay);
    while (n < MOST_FRAMES && (spent < seconds || (n < ENOUGH_FRAMES && spent < 2 * seconds)));
    Clocks end = read_clocks();
    double own = end.own - start.own;
    timing.frames = n;
    timing.ms = 1e3 * median(frames, n);
    timing.min_ms = 1e3 * frames[0];
    timing.cpu_ms = 1e3 * own / n;
    timing.others = -1;
    if (start.machine >= 0 && end.machine >= 0)
        timing.others = (end.machine - start.machine - own) / (end.wall - start.wall);
    return timing;
}
