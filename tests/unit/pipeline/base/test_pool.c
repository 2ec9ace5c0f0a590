/* Pools start the threads that a call has items for, each item runs once, and workers have numbers
 * below the count of items: what is kept for each of them need not be more. */
#include "pipeline/base/pool.h"

#include "tests/support/unit.h"

#include <dirent.h>
#include <stdatomic.h>

enum { MOST = 3000 };

typedef struct Seen {
    atomic_int times[MOST];
    atomic_int highest; /* number of a worker */
} Seen;

static void see(void *context, uint32_t item, int worker)
{
    Seen *seen = context;
    atomic_fetch_add(&seen->times[item], 1);
    int highest = atomic_load(&seen->highest);
    while (worker > highest && !atomic_compare_exchange_weak(&seen->highest, &highest, worker)) {
    }
}

/* Of this process; 0 where the system does not tell. */
static int threads_now(void)
{
    int count = 0;
    DIR *tasks = opendir("/proc/self/task");
    for (struct dirent *task; tasks && (task = readdir(tasks));)
        count += task->d_name[0] != '.';
    if (tasks)
        closedir(tasks);
    return count;
}

static void each_item_runs_once_by_workers_below_the_count(void **state)
{
    (void)state;
    static const uint32_t counts[] = { 3, 0, 1, 2, 7, MOST, 1, 64, 2, 5 };
    static const int threads[] = { 1, 2, 7, 64 };
    for (size_t t = 0; t < GP_COUNT(threads); t++) {
        GpPool *pool;
        assert_int_equal(gp_pool_create(threads[t], &pool, NULL), GP_OK);
        for (size_t i = 0; i < 20 * GP_COUNT(counts); i++) {
            static Seen seen;
            memset(&seen, 0, sizeof seen);
            const uint32_t count = counts[i % GP_COUNT(counts)];
            (i / GP_COUNT(counts) % 2 ? gp_pool_run_in_order : gp_pool_run)(pool, count, see,
                                                                            &seen);
            for (uint32_t item = 0; item < MOST; item++)
                assert_int_equal(seen.times[item], item < count);
            assert_true(seen.highest < threads[t]);
            assert_true(seen.highest < (int)count || count == 0);
        }
        gp_pool_destroy(&pool);
    }
}

typedef struct Begun {
    int threads;
    atomic_uint count;
    atomic_bool early; /* an item whose turn had not come */
} Begun;

/* Of the items below it, all but one for each other thread have begun. */
static void begin(void *context, uint32_t item, int worker)
{
    (void)worker;
    Begun *begun = context;
    if (item >= atomic_fetch_add(&begun->count, 1) + (uint32_t)begun->threads)
        atomic_store(&begun->early, true);
}

static void items_in_order_begin_by_rising_numbers(void **state)
{
    (void)state;
    static const int threads[] = { 1, 2, 7 };
    for (size_t t = 0; t < GP_COUNT(threads); t++) {
        GpPool *pool;
        Begun begun = { .threads = threads[t] };
        assert_int_equal(gp_pool_create(threads[t], &pool, NULL), GP_OK);
        gp_pool_run_in_order(pool, MOST, begin, &begun);
        assert_int_equal(begun.count, MOST);
        assert_false(begun.early);
        gp_pool_destroy(&pool);
    }
}

static void threads_are_started_for_items_only(void **state)
{
    (void)state;
    static Seen seen;
    GpPool *pool;
    const int before = threads_now();
    if (!before) {
        print_message("skipped: no /proc\n");
        skip();
    }
    assert_int_equal(gp_pool_create(1024, &pool, NULL), GP_OK);
    assert_int_equal(threads_now(), before);
    gp_pool_run(pool, 4, see, &seen);
    assert_int_equal(threads_now(), before + 3);
    gp_pool_run(pool, 2, see, &seen);
    assert_int_equal(threads_now(), before + 3);
    gp_pool_destroy(&pool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_item_runs_once_by_workers_below_the_count),
        cmocka_unit_test(items_in_order_begin_by_rising_numbers),
        cmocka_unit_test(threads_are_started_for_items_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
