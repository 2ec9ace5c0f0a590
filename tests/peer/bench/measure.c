/* Wall time, the process's own processor time, and how much the rest of the machine was in the
 * way. */
#include "tests/peer/bench/measure.h"

#include "apps/base/machine.h"
#include "apps/frame/timing.h"

enum { MOST_FRAMES = 20000, ENOUGH_FRAMES = 20, WARM_FRAMES = 3 };

static double draw_frame(Replay *replay)
{
    double start = machine_clock_ms(CLOCK_MONOTONIC);
    replay_frame(replay);
    return machine_clock_ms(CLOCK_MONOTONIC) - start;
}

PeerTiming measure(Replay *replay, double seconds)
{
    const TimingPlan plan = { seconds, ENOUGH_FRAMES, 2 * seconds };
    PeerTiming timing = { .first_ms = draw_frame(replay) };
    double each[MOST_FRAMES], spent = 0;
    for (int i = 0; i < WARM_FRAMES && spent < seconds / 2 * 1e3; i++)
        spent += draw_frame(replay);
    const MachineLoad load = machine_load_begin();
    const double cpu_ms = machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID);
    spent = 0;
    do
        spent += each[timing.frames++] = draw_frame(replay);
    while (timing.frames < MOST_FRAMES && !timing_is_over(&plan, timing.frames, spent));
    timing.others = machine_others(&load);
    timing.cpu_ms = (machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID) - cpu_ms) / timing.frames;
    timing.ms = timing_median(each, timing.frames);
    timing.min_ms = each[0];
    return timing;
}
