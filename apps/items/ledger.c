#include "apps/items/ledger.h"

#include "apps/base/machine.h"
#include "apps/items/journal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <xxhash.h>

typedef enum EntryState {
    ENTRY_WAITS,
    ENTRY_IS_OUT,
    ENTRY_WAITS_AGAIN, /* to be drawn by another one, and compared */
    ENTRY_IS_OUT_AGAIN,
    ENTRY_CAME, /* and waits for those before it */
    ENTRY_DONE
} EntryState;

typedef struct Entry {
    EntryState state;
    bool checked;  /* it is to be drawn twice */
    int first;     /* worker who drew it */
    int at;        /* worker who has it */
    double out_ms; /* since when */
    uint64_t hash; /* of its first drawing */
    char *bytes;   /* until they are taken */
    size_t size;
} Entry;

struct Ledger {
    const ItemWork *work;
    ItemRun run;
    Entry *entries;
    uint32_t *order; /* item numbers, the longest first */
    uint32_t done, taken, first_waiting, again, out;
    int workers;
    char (*labels)[LEDGER_LABEL];
    Journal journal;
};

/* --- opening ---------------------------------------------------------------------------------- */

typedef struct Cost {
    double cost;
    uint32_t item;
} Cost;

static int compare_costs(const void *a, const void *b)
{
    const Cost *one = a, *other = b;
    if (one->cost != other->cost)
        return one->cost > other->cost ? -1 : 1;
    return one->item < other->item ? -1 : 1;
}

static bool sort_items(Ledger *ledger)
{
    const ItemWork *work = ledger->work;
    Cost *costs = gp_alloc(work->count + 1, sizeof *costs);
    for (uint32_t i = 0; costs && i < work->count; i++)
        costs[i] = (Cost){ work->cost ? work->cost(work->context, i) : 0, i };
    if (costs && !work->in_order)
        qsort(costs, work->count, sizeof *costs, compare_costs);
    for (uint32_t i = 0; costs && i < work->count; i++)
        ledger->order[i] = costs[i].item;
    gp_free(costs);
    return costs != NULL;
}

/* Every so manieth item, spread by its number alone. */
static bool is_checked(const ItemRun *run, uint32_t item)
{
    return (double)(XXH3_64bits(&item, sizeof item) % 10000) < run->verify * 100;
}

static void tell_progress(const Ledger *ledger, const char *name)
{
    if (ledger->run.progress)
        ledger->run.progress(ledger->run.user, ledger->done, ledger->work->count, name);
}

static ItemsCode take(Ledger *ledger, uint32_t item, GpError *error)
{
    const ItemWork *work = ledger->work;
    Entry *entry = &ledger->entries[item];
    char name[ITEM_NAME];
    const GpResult result =
        work->take(work->context, item, entry->bytes ? entry->bytes : "", entry->size, error);
    gp_free(entry->bytes);
    entry->bytes = NULL;
    entry->state = ENTRY_DONE;
    ledger->done++;
    work->tell(work->context, item, name);
    if (!result)
        tell_progress(ledger, name);
    return result ? ITEMS_INTERNAL : ITEMS_DONE;
}

/* What has come, as far as its order allows. */
static ItemsCode take_all(Ledger *ledger, uint32_t item, GpError *error)
{
    if (!ledger->work->in_order)
        return take(ledger, item, error);
    ItemsCode code = ITEMS_DONE;
    while (!code && ledger->taken < ledger->work->count &&
           ledger->entries[ledger->taken].state == ENTRY_CAME)
        code = take(ledger, ledger->taken++, error);
    return code;
}

static GpResult put_noted(void *context, uint32_t item, char *bytes, size_t size, GpError *error)
{
    Ledger *ledger = context;
    Entry *entry = item < ledger->work->count ? &ledger->entries[item] : NULL;
    if (!entry || entry->state != ENTRY_WAITS) {
        gp_free(bytes);
        return gp_fail(error, GP_ERROR_FORMAT, "%.200s: no journal of this work",
                       ledger->run.journal);
    }
    *entry = (Entry){ .state = ENTRY_CAME, .bytes = bytes, .size = size };
    return take_all(ledger, item, error) ? GP_ERROR_IO : GP_OK;
}

static ItemsCode open_journal(Ledger *ledger, GpError *error)
{
    const ItemRun *run = &ledger->run;
    if (!run->journal)
        return ITEMS_DONE;
    const GpResult result = journal_open(run->journal, run->key, run->resume, put_noted, ledger,
                                         &ledger->journal, error);
    if (result == GP_ERROR_IO && !run->resume) { /* nobody asked for one, and there is no place */
        ledger->run.journal = NULL;
        return ITEMS_DONE;
    }
    return result == GP_ERROR_FORMAT ? ITEMS_INPUT : result ? ITEMS_INTERNAL : ITEMS_DONE;
}

ItemsCode ledger_open(const ItemWork *work, const ItemRun *run, int workers, Ledger **ledger,
                      GpError *error)
{
    Ledger *made = gp_alloc(1, sizeof *made);
    if (!made)
        return items_code(gp_fail(error, GP_ERROR_MEMORY, "out of memory"));
    *made = (Ledger){ .work = work,
                      .run = *run,
                      .workers = workers,
                      .entries = gp_alloc(work->count + 1, sizeof *made->entries),
                      .order = gp_alloc(work->count + 1, sizeof *made->order),
                      .labels = gp_alloc((size_t)workers + 1, LEDGER_LABEL) };
    *ledger = made;
    if (!made->entries || !made->order || !made->labels || !sort_items(made))
        return items_code(gp_fail(error, GP_ERROR_MEMORY, "out of memory"));
    for (uint32_t i = 0; i < work->count; i++)
        made->entries[i].checked = workers > 1 && is_checked(run, i);
    return open_journal(made, error);
}

ItemsCode ledger_close(Ledger **ledger, ItemsCode code, GpError *error)
{
    Ledger *closed = *ledger;
    *ledger = NULL;
    if (!closed)
        return code;
    const GpResult ended = journal_close(&closed->journal, !code, code ? NULL : error);
    for (uint32_t i = 0; closed->entries && i < closed->work->count; i++)
        gp_free(closed->entries[i].bytes);
    gp_free(closed->entries);
    gp_free(closed->order);
    gp_free(closed->labels);
    gp_free(closed);
    return code ? code : ended ? ITEMS_INTERNAL : ITEMS_DONE;
}

void ledger_name_worker(Ledger *ledger, int worker, const char *label)
{
    snprintf(ledger->labels[worker], LEDGER_LABEL, "%s", label);
}

bool ledger_is_done(const Ledger *ledger)
{
    return ledger->done == ledger->work->count;
}

/* --- handing out ------------------------------------------------------------------------------ */

static bool may_go_out(const Ledger *ledger, uint32_t item, int worker)
{
    const Entry *entry = &ledger->entries[item];
    if (ledger->work->in_order && item >= ledger->taken + 2 * (uint32_t)ledger->workers + 2)
        return false; /* its bytes would wait here */
    return entry->state == ENTRY_WAITS ||
           (entry->state == ENTRY_WAITS_AGAIN && entry->first != worker);
}

static void hand_out(Ledger *ledger, uint32_t item, int worker)
{
    Entry *entry = &ledger->entries[item];
    if (entry->state == ENTRY_WAITS_AGAIN)
        ledger->again--;
    entry->state = entry->state == ENTRY_WAITS ? ENTRY_IS_OUT : ENTRY_IS_OUT_AGAIN;
    entry->at = worker;
    entry->out_ms = machine_clock_ms(CLOCK_MONOTONIC);
    ledger->out++;
}

/* Those that wait for a second drawing come first: their bytes wait with them. */
static bool next_again(Ledger *ledger, int worker, uint32_t *item)
{
    for (uint32_t i = 0; ledger->again > 0 && i < ledger->work->count; i++)
        if (ledger->entries[i].state == ENTRY_WAITS_AGAIN && may_go_out(ledger, i, worker)) {
            *item = i;
            hand_out(ledger, i, worker);
            return true;
        }
    return false;
}

bool ledger_next(Ledger *ledger, int worker, uint32_t *item)
{
    if (next_again(ledger, worker, item))
        return true;
    while (ledger->first_waiting < ledger->work->count &&
           ledger->entries[ledger->order[ledger->first_waiting]].state != ENTRY_WAITS)
        ledger->first_waiting++;
    if (ledger->first_waiting == ledger->work->count ||
        !may_go_out(ledger, ledger->order[ledger->first_waiting], worker))
        return false;
    *item = ledger->order[ledger->first_waiting++];
    hand_out(ledger, *item, worker);
    return true;
}

bool ledger_next_short(Ledger *ledger, int worker, uint32_t *item)
{
    if (ledger->work->in_order)
        return ledger_next(ledger, worker, item);
    if (next_again(ledger, worker, item))
        return true;
    for (uint32_t i = ledger->work->count; i-- > ledger->first_waiting;)
        if (ledger->entries[ledger->order[i]].state == ENTRY_WAITS) {
            *item = ledger->order[i];
            hand_out(ledger, *item, worker);
            return true;
        }
    return false;
}

/* --- what comes back -------------------------------------------------------------------------- */

static ItemsCode fail_by(const Ledger *ledger, uint32_t item, int worker, const Drawn *drawn,
                         GpError *error)
{
    char name[ITEM_NAME];
    ledger->work->tell(ledger->work->context, item, name);
    const char *label = ledger->labels[worker];
    return items_code(gp_fail(error, drawn->result, "%s%s%s: %.300s", name, label[0] ? ", " : "",
                              label, drawn->error.text));
}

static ItemsCode keep_or_take(Ledger *ledger, uint32_t item, GpError *error)
{
    Entry *entry = &ledger->entries[item];
    GpResult result = ledger->run.journal
                          ? journal_add(&ledger->journal, item, entry->bytes, entry->size, error)
                          : GP_OK;
    entry->state = ENTRY_CAME;
    return result ? ITEMS_INTERNAL : take_all(ledger, item, error);
}

static ItemsCode put_second(Ledger *ledger, uint32_t item, int worker, uint64_t hash,
                            GpError *error)
{
    const Entry *entry = &ledger->entries[item];
    char name[ITEM_NAME];
    if (hash == entry->hash)
        return keep_or_take(ledger, item, error);
    ledger->work->tell(ledger->work->context, item, name);
    gp_fail(error, GP_ERROR_INVALID,
            "%s: %s and %s drew different bits (%016llx, %016llx): faulty memory, or another build",
            name, ledger->labels[entry->first], ledger->labels[worker],
            (unsigned long long)entry->hash, (unsigned long long)hash);
    return ITEMS_DIFFER;
}

ItemsCode ledger_put(Ledger *ledger, Drawn *drawn, int worker, GpError *error)
{
    const uint32_t item = drawn->item;
    Entry *entry = &ledger->entries[item];
    const bool again = entry->state == ENTRY_IS_OUT_AGAIN;
    GP_ASSERT(again || entry->state == ENTRY_IS_OUT);
    ledger->out--;
    if (drawn->result) {
        gp_free(drawn->bytes);
        return fail_by(ledger, item, worker, drawn, error);
    }
    const uint64_t hash = XXH3_64bits(drawn->bytes ? drawn->bytes : "", drawn->same);
    if (again) {
        gp_free(drawn->bytes);
        return put_second(ledger, item, worker, hash, error);
    }
    entry->bytes = drawn->bytes;
    entry->size = drawn->size;
    entry->first = worker;
    entry->hash = hash;
    if (!entry->checked)
        return keep_or_take(ledger, item, error);
    entry->state = ENTRY_WAITS_AGAIN;
    ledger->again++;
    return ITEMS_DONE;
}

/* --- time ------------------------------------------------------------------------------------- */

static bool is_out(const Entry *entry)
{
    return entry->state == ENTRY_IS_OUT || entry->state == ENTRY_IS_OUT_AGAIN;
}

/* The item that is out for longest, of one worker or, with -1, of all; NULL: none. */
static const Entry *longest_out(const Ledger *ledger, int worker)
{
    const Entry *longest = NULL;
    for (uint32_t i = 0; ledger->out > 0 && i < ledger->work->count; i++) {
        const Entry *entry = &ledger->entries[i];
        if (is_out(entry) && (worker < 0 || entry->at == worker) &&
            (!longest || entry->out_ms < longest->out_ms))
            longest = entry;
    }
    return longest;
}

ItemsCode ledger_look_at_time(const Ledger *ledger, GpError *error)
{
    char name[ITEM_NAME];
    const double timeout = ledger->run.timeout;
    const Entry *longest = timeout > 0 ? longest_out(ledger, -1) : NULL;
    if (!longest || machine_clock_ms(CLOCK_MONOTONIC) - longest->out_ms < timeout * 1e3)
        return ITEMS_DONE;
    ledger->work->tell(ledger->work->context, (uint32_t)(longest - ledger->entries), name);
    gp_fail(error, GP_ERROR_INVALID, "%s: %s has not drawn it in %g s", name,
            ledger->labels[longest->at], timeout);
    if (ledger->run.end)
        ledger->run.end(ITEMS_INTERNAL, error->text);
    return ITEMS_INTERNAL;
}

bool ledger_at(const Ledger *ledger, int worker, char name[ITEM_NAME])
{
    const Entry *entry = longest_out(ledger, worker);
    if (entry)
        ledger->work->tell(ledger->work->context, (uint32_t)(entry - ledger->entries), name);
    return entry != NULL;
}
