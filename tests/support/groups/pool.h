/* A pool for a whole group of tests, of POOL_THREADS threads, 1 where a test does not say:
 * cmocka_run_group_tests(tests, pool_set_up, pool_tear_down). */
#ifndef TESTS_GROUPS_POOL_H
#define TESTS_GROUPS_POOL_H

#include "pipeline/base/pool.h"

#ifndef POOL_THREADS
#define POOL_THREADS 1
#endif

static GpPool *pool;

static inline int pool_set_up(void **state)
{
    (void)state;
    return gp_pool_create(POOL_THREADS, &pool, NULL);
}

static inline int pool_tear_down(void **state)
{
    (void)state;
    gp_pool_destroy(&pool);
    return 0;
}

#endif
