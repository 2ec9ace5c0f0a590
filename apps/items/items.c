#include "apps/items/items.h"

#include "apps/base/machine.h"
#include "apps/items/drawers.h"
#include "apps/items/ledger.h"

#include <stdio.h>

static const ItemRunner *runner;

void items_set_runner(const ItemRunner *other)
{
    runner = other;
}

bool items_are_shared(void)
{
    return runner != NULL;
}

uint32_t items_threads(const ItemRun *run)
{
    const uint32_t own = runner ? runner->threads : (uint32_t)machine_processors();
    return run->device.threads ? (uint32_t)run->device.threads : own;
}

uint32_t items_at_once(const ItemRun *run)
{
    return runner ? runner->at_once(run) : items_threads(run);
}

/* --- this process's threads ------------------------------------------------------------------- */

/* in     most: items that may be drawn at once */
static ItemsCode give_and_take(Ledger *ledger, Drawers *drawers, uint32_t most, GpError *error)
{
    ItemsCode code = ITEMS_DONE;
    uint32_t item, at_work = 0;
    while (!ledger_is_done(ledger) && !code) {
        for (int free = drawers_find_free(drawers, 0); free >= 0 && at_work < most;
             free = drawers_find_free(drawers, free + 1))
            if (ledger_next(ledger, free, &item)) { /* what is drawn twice is not for all */
                drawers_give(drawers, free, item);
                at_work++;
            }
        Drawn drawn;
        if (drawers_wait(drawers, 0.1, &drawn)) {
            at_work--;
            code = ledger_put(ledger, &drawn, drawn.drawer, error);
        }
        if (!code)
            code = ledger_look_at_time(ledger, error);
    }
    return code;
}

static ItemsCode run_here(const ItemWork *work, const ItemRun *run, GpError *error)
{
    const uint32_t threads = items_threads(run);
    uint32_t count = work->measures ? 1 : threads < work->count ? threads : work->count;
    count = run->verify > 0 && count < 2 ? 2 : count; /* the other one is to check */
    ItemRun own = *run;
    own.journal = run->resume ? run->journal : NULL;
    Ledger *ledger = NULL;
    Drawers *drawers = NULL;
    ItemsCode code = ledger_open(work, &own, (int)count, &ledger, error);
    if (!code)
        code = drawers_start(work, &run->device, count, run->verify > 0 ? 2 : 1,
                             work->measures    ? threads
                             : threads > count ? threads / count
                                               : 1,
                             &drawers, error);
    const bool tells_who = run->verify > 0 || run->timeout > 0;
    for (uint32_t i = 0; i < count && !code && tells_who; i++) {
        char label[LEDGER_LABEL];
        snprintf(label, sizeof label, "thread %u", i + 1);
        ledger_name_worker(ledger, (int)i, label);
    }
    if (!code)
        code = give_and_take(ledger, drawers, work->measures ? 1 : count, error);
    drawers_stop(&drawers, code != ITEMS_INTERNAL || run->timeout <= 0 || run->end);
    return ledger_close(&ledger, code, error);
}

ItemsCode items_run(const ItemWork *work, const ItemRun *run, GpError *error)
{
    return runner ? runner->run(work, run, error) : run_here(work, run, error);
}
