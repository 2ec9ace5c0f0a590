#include "apps/mpi/runner.h"

#include "apps/base/machine.h"
#include "apps/items/ledger.h"
#include "apps/mpi/last_words.h"
#include "apps/mpi/messages.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Of this process. */
static int own_rank, rank_count;
static const Host *hosts;
static bool started, stopped;  /* ranks other than 0 */
static bool called, dismissed; /* rank 0: they were told to start, to stop */
static int failed_code;        /* of a rank's command before its items */
static char failed_line[1024];

/* Without work, looks for messages so often. */
static void rest(void)
{
    nanosleep(&(struct timespec){ .tv_nsec = 200000 }, NULL);
}

/* --- ranks other than 0 ----------------------------------------------------------------------- */

bool runner_wait_for_start(void)
{
    int rank;
    Message message;
    size_t size;
    while (!message_look(&rank, &message, &size))
        rest();
    message_take(rank, message, NULL, 0);
    started = message == MESSAGE_START;
    stopped = !started;
    return started;
}

void runner_note_failure(int code, const char *line)
{
    failed_code = code;
    snprintf(failed_line, sizeof failed_line, "%s", line);
}

void runner_say_failure(void)
{
    char text[sizeof(int32_t) + sizeof failed_line] = "";
    const int32_t code = failed_code ? failed_code : ITEMS_INTERNAL;
    if (!started || stopped)
        return;
    memcpy(text, &code, sizeof code);
    snprintf(text + sizeof code, sizeof text - sizeof code, "%s",
             failed_line[0] ? failed_line : "ended before its work began");
    message_send(0, MESSAGE_FAILED, text, sizeof code + strlen(text + sizeof code));
    Message message = MESSAGE_GIVE;
    while (message != MESSAGE_STOP) { /* until nobody waits for this rank */
        int rank;
        size_t size;
        uint32_t item;
        if (message_look(&rank, &message, &size))
            message_take(rank, message, &item, size);
        else
            rest();
    }
}

/* Items that this rank was given and has not begun: a few. */
typedef struct Given {
    uint32_t items[1032];
    size_t first, end;
} Given;

static void draw_given(Drawers *drawers, Given *given)
{
    for (int free = drawers_find_free(drawers, 0); free >= 0 && given->first < given->end;
         free = drawers_find_free(drawers, 0))
        drawers_give(drawers, free, given->items[given->first++]);
    if (given->first == given->end)
        given->first = given->end = 0;
}

static void take_message(Given *given)
{
    int rank;
    Message message;
    size_t size;
    while (!stopped && message_look(&rank, &message, &size)) {
        uint32_t item = 0;
        message_take(rank, message, &item, size);
        stopped = message == MESSAGE_STOP;
        if (message == MESSAGE_GIVE && given->end < GP_COUNT(given->items))
            given->items[given->end++] = item;
    }
}

/* Draws until rank 0 has no more, and ends the process: what comes after its items is rank 0's
 * alone. */
static ItemsCode draw_for_rank_0(const ItemWork *work, const ItemRun *run, GpError *error)
{
    static Given given;
    const uint32_t threads = items_threads(run), count = work->measures ? 1 : threads;
    Drawers *drawers = NULL;
    Drawn drawn;
    const ItemsCode code =
        drawers_start(work, &run->device, count, 1, threads / count, &drawers, error);
    if (code)
        return code;
    message_send(0, MESSAGE_READY, &count, sizeof count);
    while (!stopped) {
        take_message(&given);
        draw_given(drawers, &given);
        if (drawers_wait(drawers, 0.0005, &drawn))
            message_send_drawn(&drawn);
    }
    drawers_stop(&drawers, false);
    exit(0);
}

/* --- rank 0 ----------------------------------------------------------------------------------- */

void runner_dismiss(void)
{
    for (int rank = 1; rank < rank_count && !dismissed; rank++)
        message_send(rank, MESSAGE_STOP, NULL, 0);
    dismissed = true;
}

static void call_all(void)
{
    for (int rank = 1; rank < rank_count && !called; rank++)
        message_send(rank, MESSAGE_START, NULL, 0);
    called = true;
}

/* A run in hand. */
typedef struct Job {
    Ledger *ledger;
    Drawers *drawers;
    uint32_t *room; /* [rank_count]: items that a rank could still be given */
    double busy_ms; /* of rank 0, with messages and what comes by them */
} Job;

/* What an item's end would bring the ranks to say. */
static void tell_last_words(const Job *job, int rank)
{
    char name[ITEM_NAME] = "";
    ledger_at(job->ledger, rank, name);
    last_words_set(rank, name);
}

static ItemsCode take_failure(int rank, const char *text, size_t size, GpError *error)
{
    int32_t code = ITEMS_INTERNAL;
    memcpy(&code, text, sizeof code < size ? sizeof code : size);
    gp_fail(error, GP_ERROR_INVALID, "rank %d on %s: %.*s", rank, hosts[rank].name,
            (int)(size - sizeof code), text + sizeof code);
    return (ItemsCode)code;
}

static ItemsCode take_drawn(Job *job, int rank, const char *data, size_t size, GpError *error)
{
    Drawn drawn;
    if (!message_read_drawn(data, size, &drawn))
        return items_code(gp_fail(error, GP_ERROR_MEMORY, "out of memory"));
    job->room[rank]++;
    return ledger_put(job->ledger, &drawn, rank, error);
}

static ItemsCode take_one(Job *job, int rank, Message message, size_t size, GpError *error)
{
    ItemsCode code = ITEMS_DONE;
    uint32_t count = 0;
    char *data = gp_alloc_unset(size + 1);
    if (!data)
        return items_code(gp_fail(error, GP_ERROR_MEMORY, "no memory for %zu bytes", size));
    message_take(rank, message, data, size);
    if (message == MESSAGE_READY && size == sizeof count) {
        memcpy(&count, data, sizeof count);
        job->room[rank] = count + 1; /* one waits there, so that no drawer does */
    } else if (message == MESSAGE_DRAWN) {
        code = take_drawn(job, rank, data, size, error);
    } else if (message == MESSAGE_FAILED) {
        code = take_failure(rank, data, size, error);
    }
    gp_free(data);
    return code;
}

static ItemsCode take_messages(Job *job, bool *any, GpError *error)
{
    int rank;
    Message message;
    size_t size;
    ItemsCode code = ITEMS_DONE;
    while (!code && message_look(&rank, &message, &size)) {
        code = take_one(job, rank, message, size, error);
        *any = true;
        if (!code)
            tell_last_words(job, rank);
    }
    return code;
}

/* The longest to the others, the shortest here: where one is at work here, messages have to wait
 * for nobody, but its end is the run's. */
static void hand_out(Job *job)
{
    uint32_t item;
    for (int rank = 1; rank < rank_count; rank++)
        while (job->room[rank] > 0 && ledger_next(job->ledger, rank, &item)) {
            message_send(rank, MESSAGE_GIVE, &item, sizeof item);
            job->room[rank]--;
            tell_last_words(job, rank);
        }
    for (int free = drawers_find_free(job->drawers, 0);
         free >= 0 && ledger_next_short(job->ledger, 0, &item);
         free = drawers_find_free(job->drawers, 0)) {
        drawers_give(job->drawers, free, item);
        tell_last_words(job, 0);
    }
}

static ItemsCode lead(Job *job, GpError *error)
{
    ItemsCode code = ITEMS_DONE;
    while (!code && !ledger_is_done(job->ledger)) {
        bool any = false;
        Drawn drawn;
        const double begin = machine_clock_ms(CLOCK_MONOTONIC);
        hand_out(job);
        code = take_messages(job, &any, error);
        job->busy_ms += any ? machine_clock_ms(CLOCK_MONOTONIC) - begin : 0;
        if (!code && drawers_wait(job->drawers, any ? 0 : 0.0005, &drawn)) {
            code = ledger_put(job->ledger, &drawn, 0, error);
            tell_last_words(job, 0);
        }
        if (!code)
            code = ledger_look_at_time(job->ledger, error);
    }
    return code;
}

static ItemsCode open_job(const ItemWork *work, const ItemRun *run, Job *job, GpError *error)
{
    const uint32_t threads = items_threads(run), count = work->measures ? 1 : threads;
    job->room = gp_alloc((size_t)rank_count, sizeof *job->room);
    if (!job->room)
        return items_code(gp_fail(error, GP_ERROR_MEMORY, "out of memory"));
    ItemsCode code = ledger_open(work, run, rank_count, &job->ledger, error);
    for (int rank = 0; rank < rank_count && !code; rank++) {
        char label[LEDGER_LABEL];
        snprintf(label, sizeof label, "rank %d on %s", rank, hosts[rank].name);
        ledger_name_worker(job->ledger, rank, label);
    }
    if (!code && !ledger_is_done(job->ledger))
        code = drawers_start(work, &run->device, count, 1, threads / count, &job->drawers, error);
    return code;
}

/* For those who want to know what a message costs. */
static void tell_counts(const ItemWork *work, const Job *job, double begin_ms)
{
    if (!getenv("GLASSPIPE_MPI_COUNTS"))
        return;
    fprintf(stderr,
            "%u items on %d ranks: %.3f s; rank 0: %llu messages, %llu bytes, %.3f ms with them\n",
            work->count, rank_count, (machine_clock_ms(CLOCK_MONOTONIC) - begin_ms) / 1e3,
            message_count.messages, message_count.bytes, job->busy_ms);
}

static ItemsCode lead_all(const ItemWork *work, const ItemRun *run, GpError *error)
{
    Job job = { .ledger = NULL };
    const double begin = machine_clock_ms(CLOCK_MONOTONIC);
    ItemsCode code = open_job(work, run, &job, error);
    if (!code && !ledger_is_done(job.ledger)) {
        call_all();
        code = lead(&job, error);
    }
    runner_dismiss();
    drawers_stop(&job.drawers, true);
    gp_free(job.room);
    tell_counts(work, &job, begin);
    return ledger_close(&job.ledger, code, error);
}

/* --- the runner ------------------------------------------------------------------------------- */

static ItemsCode run_items(const ItemWork *work, const ItemRun *run, GpError *error)
{
    return own_rank == 0 ? lead_all(work, run, error) : draw_for_rank_0(work, run, error);
}

static uint32_t at_once(const ItemRun *run)
{
    uint32_t count = 0;
    for (int rank = 0; rank < rank_count; rank++)
        count +=
            run->device.threads ? (uint32_t)run->device.threads : (uint32_t)hosts[rank].threads;
    return count;
}

void runner_begin(int rank, int count, const Host *all)
{
    static ItemRunner own = { .run = run_items, .at_once = at_once };
    own_rank = rank;
    rank_count = count;
    hosts = all;
    own.threads = (uint32_t)hosts[rank].threads;
    last_words_begin(rank, count, all);
    if (count > 1)
        items_set_runner(&own);
}

void runner_say_last_words(int number)
{
    last_words_say(number);
}
