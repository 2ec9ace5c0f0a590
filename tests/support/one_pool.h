/* A pool of one thread for a whole group of tests: cmocka_run_group_tests(tests, pool_set_up,
 * pool_tear_down). */
#ifndef TESTS_ONE_POOL_H
#define TESTS_ONE_POOL_H

#include "pipeline/base/pool.h"

static GpPool *pool;

static inline int pool_set_up(void **state)
{
    (void)state;
    return gp_pool_create(1, &pool, NULL);
}

static inline int pool_tear_down(void **state)
{
    (void)state;
    gp_pool_destroy(&pool);
    return 0;
}

#endif
