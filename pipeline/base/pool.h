/* A pool of threads that run numbered items of work, and sleep in between. */
#ifndef GP_POOL_H
#define GP_POOL_H

#include "pipeline/base/base.h"

typedef struct GpPool GpPool;

/* Does one item. worker: below the pool's threads and below the call's items, the same for all
 * items that one thread does in a call. */
typedef void (*GpPoolFn)(void *context, uint32_t item, int worker);

/* Creates a pool of `threads` workers, 1..1024; the thread that calls gp_pool_run is worker 0. The
 * others are started by the first call that has an item for each; where the system refuses a
 * thread, those that are there do its work.
 * errors GP_ERROR_MEMORY */
GpResult gp_pool_create(int threads, GpPool **pool, GpError *error);
void gp_pool_destroy(GpPool **pool); /* NULL-safe, sets NULL */

int gp_pool_threads(const GpPool *pool);

/* Runs items 0..count-1, each once, by any worker in any order; returns when all are done. What one
 * item writes, later calls see. Results must not depend on the worker. One caller at a time.
 *
 * Each worker begins with as many items in a row, which in calls that follow each other mostly are
 * the same: what they read and write is then in its own caches (frames take 1.5 % less, many small
 * draws 2.5). */
void gp_pool_run(GpPool *pool, uint32_t count, GpPoolFn function, void *context);

/* The same, where items begin by rising numbers. */
void gp_pool_run_in_order(GpPool *pool, uint32_t count, GpPoolFn function, void *context);

#endif
