/* A pool of threads that share items of work; they look at a word for a while before they sleep. */
#define _GNU_SOURCE /* for the processors of a thread, where Linux runs it */
#include "pipeline/base/pool.h"

#include "pipeline/base/fpcontrol.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <unistd.h>

typedef struct Worker {
    GpPool *pool;
    int number;
    unsigned seen; /* the last round it knows of */
    pthread_t thread;
} Worker;

/* Looks at a word that is about to change before a thread sleeps. The phases of a frame follow each
 * other within the tenth of a millisecond that the longer wait takes; waking a thread takes as
 * long. Where threads are more than processors, whoever looks is in the way of one that works. */
enum { LOOKS = 4000, LOOKS_IF_CROWDED = 200 };

/* Items in a row that belong to one worker. Whoever is done takes those of others. */
typedef struct Part {
    _Alignas(64) atomic_uint next;
    uint32_t end;
} Part;

struct GpPool {
    int threads;
    int started;     /* of them, worker 0 included */
    int invited;     /* to the round: those with a lower number */
    int looks;       /* of a worker, before it sleeps */
    Worker *workers; /* number 0 has no thread of its own */
    pthread_mutex_t mutex;
    pthread_cond_t work_came, work_done;
    unsigned round;     /* calls of gp_pool_run so far; workers wait for it to change */
    atomic_uint called; /* the same, said once the mutex is free: who looks would run into it */
    atomic_int inside;  /* workers that have joined the round and not finished it */
    bool open; /* the round may still be joined: whoever wakes too late is not waited for */
    bool stop;

    GpPoolFn function;
    void *context;
    Part *parts; /* of each worker; of those invited they are set */
};

static void pause_briefly(void)
{
#if defined __x86_64__ || defined __i386__
    __builtin_ia32_pause();
#elif defined __aarch64__
    __asm__ volatile("yield");
#endif
}

/* Looks before it takes, so that many who are done do not fight over parts that have nothing
 * left. */
static void do_part(GpPool *pool, Part *part, int worker)
{
    while (atomic_load_explicit(&part->next, memory_order_relaxed) < part->end) {
        const uint32_t item = atomic_fetch_add_explicit(&part->next, 1, memory_order_relaxed);
        if (item < part->end)
            pool->function(pool->context, item, worker);
    }
}

static void do_items(GpPool *pool, int worker)
{
    GpFpControl control = gp_fp_enter();
    for (int i = worker; i < pool->invited; i++)
        do_part(pool, &pool->parts[i], worker);
    for (int i = 0; i < worker; i++)
        do_part(pool, &pool->parts[i], worker);
    gp_fp_leave(control);
}

static void *work(void *argument)
{
    Worker *worker = argument;
    GpPool *pool = worker->pool;
    unsigned seen = worker->seen;
    for (;;) {
        for (int look = 0; look < pool->looks && atomic_load(&pool->called) == seen; look++)
            pause_briefly();
        pthread_mutex_lock(&pool->mutex);
        while (pool->round == seen && !pool->stop)
            pthread_cond_wait(&pool->work_came, &pool->mutex);
        seen = pool->round;
        bool join = pool->open && worker->number < pool->invited, stop = pool->stop;
        if (join)
            atomic_fetch_add(&pool->inside, 1);
        pthread_mutex_unlock(&pool->mutex);
        if (stop)
            return NULL;
        if (!join)
            continue;
        do_items(pool, worker->number);
        if (atomic_fetch_sub(&pool->inside, 1) > 1)
            continue;
        pthread_mutex_lock(&pool->mutex); /* whoever saw others inside is asleep by then */
        pthread_cond_signal(&pool->work_done);
        pthread_mutex_unlock(&pool->mutex);
    }
}

static void stop_workers(GpPool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    pool->stop = true;
    pthread_cond_broadcast(&pool->work_came);
    pthread_mutex_unlock(&pool->mutex);
    for (int i = 1; i < pool->started; i++)
        pthread_join(pool->workers[i].thread, NULL);
    pthread_cond_destroy(&pool->work_came);
    pthread_cond_destroy(&pool->work_done);
    pthread_mutex_destroy(&pool->mutex);
    gp_free(pool->workers);
    gp_free(pool->parts);
    gp_free(pool);
}

GpResult gp_pool_create(int threads, GpPool **pool, GpError *error)
{
    GP_ASSERT(threads >= 1 && threads <= 1024);
    GpPool *p = gp_alloc(1, sizeof *p);
    Worker *workers = gp_alloc((size_t)threads, sizeof *workers);
    Part *parts = gp_alloc((size_t)threads, sizeof *parts);
    if (!p || !workers || !parts) {
        gp_free(p);
        gp_free(workers);
        gp_free(parts);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %d threads", threads);
    }
    p->threads = threads;
    p->started = 1;
    p->looks = threads <= sysconf(_SC_NPROCESSORS_ONLN) ? LOOKS : LOOKS_IF_CROWDED;
    p->workers = workers;
    p->parts = parts;
    pthread_mutex_init(&p->mutex, NULL);
    pthread_cond_init(&p->work_came, NULL);
    pthread_cond_init(&p->work_done, NULL);
    *pool = p;
    return GP_OK;
}

void gp_pool_destroy(GpPool **pool)
{
    if (*pool)
        stop_workers(*pool);
    *pool = NULL;
}

int gp_pool_threads(const GpPool *pool)
{
    return pool->threads;
}

/* A thread may begin on the processor of who made it, and wait there for a tick while others are
 * idle: it is sent away once, and free from then on. Whole commands of 30 ms take 2 to 10 %
 * less. */
static void begin_elsewhere(pthread_t thread)
{
#ifdef __linux__
    cpu_set_t all, others;
    const int here = sched_getcpu();
    if (here < 0 || sched_getaffinity(0, sizeof all, &all))
        return;
    others = all;
    CPU_CLR((size_t)here, &others);
    if (!pthread_setaffinity_np(thread, sizeof others, &others))
        pthread_setaffinity_np(thread, sizeof all, &all);
#else
    (void)thread;
#endif
}

static void start_workers(GpPool *pool, int wanted)
{
    for (; pool->started < wanted; pool->started++) {
        Worker *worker = &pool->workers[pool->started];
        *worker = (Worker){ .pool = pool, .number = pool->started, .seen = pool->round };
        if (pthread_create(&worker->thread, NULL, work, worker))
            return;
        begin_elsewhere(worker->thread);
    }
}

static void open_round(GpPool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    pool->open = true;
    const unsigned round = ++pool->round;
    pthread_cond_broadcast(&pool->work_came);
    pthread_mutex_unlock(&pool->mutex);
    atomic_store(&pool->called, round);
}

static void close_round(GpPool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    pool->open = false;
    pthread_mutex_unlock(&pool->mutex);
    for (int look = 0; look < pool->looks && atomic_load(&pool->inside); look++)
        pause_briefly();
    if (!atomic_load(&pool->inside))
        return;
    pthread_mutex_lock(&pool->mutex);
    while (atomic_load(&pool->inside))
        pthread_cond_wait(&pool->work_done, &pool->mutex);
    pthread_mutex_unlock(&pool->mutex);
}

/* The first of the items of a worker, of which `sharers` have parts. */
static uint32_t part_begin(uint32_t count, int worker, int sharers)
{
    return worker < sharers ? (uint32_t)((uint64_t)count * (uint64_t)worker / (uint64_t)sharers)
                            : count;
}

static void invite_workers(GpPool *pool, uint32_t count)
{
    GP_ASSERT(count <= UINT32_MAX / 2); /* `next` must not wrap when every worker overshoots */
    const int wanted = count < (uint32_t)pool->threads ? (int)count : pool->threads;
    start_workers(pool, wanted);
    pool->invited = wanted < pool->started ? wanted : pool->started;
}

static void run(GpPool *pool, uint32_t count, bool in_order, GpPoolFn function, void *context)
{
    invite_workers(pool, count);
    const int sharers = in_order ? 1 : pool->invited;
    const bool alone = pool->invited <= 1;
    pool->function = function;
    pool->context = context;
    for (int i = 0; i < pool->invited; i++) {
        Part *part = &pool->parts[i];
        atomic_store_explicit(&part->next, part_begin(count, i, sharers), memory_order_relaxed);
        part->end = part_begin(count, i + 1, sharers);
    }
    if (!alone)
        open_round(pool);
    do_items(pool, 0);
    if (!alone)
        close_round(pool);
}

void gp_pool_run(GpPool *pool, uint32_t count, GpPoolFn function, void *context)
{
    run(pool, count, false, function, context);
}

void gp_pool_run_in_order(GpPool *pool, uint32_t count, GpPoolFn function, void *context)
{
    run(pool, count, true, function, context);
}
