/* Items: all are drawn and taken once, in whatever order; what goes wrong ends the run and says
 * what. */
#include "apps/items/items.h"
#include "apps/items/ledger.h"
#include "tests/support/unit.h"

#include <stdatomic.h>
#include <stdio.h>
#include <unistd.h>

enum { COUNT = 40 };

/* Item i is its number, as many times as a little more than its number. */
typedef struct Numbers {
    uint32_t taken[COUNT], order[COUNT], count;
    atomic_int drawn;
    uint32_t fails, breaks; /* items, from 1, that cannot be drawn, and taken; 0: none */
    bool differs;           /* each drawing is another */
    unsigned sleep_us;
    atomic_int at_once, most_at_once; /* drawings */
    atomic_int threads;               /* of the device that drew last */
} Numbers;

static void tell(const void *context, uint32_t item, char name[ITEM_NAME])
{
    (void)context;
    snprintf(name, ITEM_NAME, "number %u", item);
}

static double cost(const void *context, uint32_t item)
{
    (void)context;
    return (item * 7) % COUNT;
}

static GpResult draw(const void *context, uint32_t item, const ItemTools *tools, GpBytes *bytes,
                     size_t *same, GpError *error)
{
    Numbers *numbers = (Numbers *)context;
    assert_non_null(tools->device);
    const int at_once = atomic_fetch_add(&numbers->at_once, 1) + 1;
    if (at_once > numbers->most_at_once)
        numbers->most_at_once = at_once;
    numbers->threads = gp_device_threads(tools->device);
    usleep(numbers->sleep_us);
    atomic_fetch_sub(&numbers->at_once, 1);
    const int drawing = atomic_fetch_add(&numbers->drawn, 1);
    if (numbers->fails == item + 1)
        return gp_fail(error, GP_ERROR_IO, "nothing to read");
    for (uint32_t i = 0; i < item + 2; i++)
        gp_bytes_append(bytes, &item, sizeof item);
    *same = bytes->size;
    gp_bytes_append(bytes, &drawing, sizeof drawing); /* this is another one each time */
    if (numbers->differs)
        *same = bytes->size;
    return GP_OK;
}

static GpResult take(void *context, uint32_t item, const void *bytes, size_t size, GpError *error)
{
    Numbers *numbers = context;
    uint32_t first;
    if (numbers->breaks == item + 1)
        return gp_fail(error, GP_ERROR_IO, "the disk is full");
    assert_int_equal(size, (item + 3) * sizeof item);
    memcpy(&first, bytes, sizeof first);
    assert_int_equal(first, item);
    numbers->taken[item]++;
    numbers->order[numbers->count++] = item;
    return GP_OK;
}

static ItemWork work_of(Numbers *numbers)
{
    return (ItemWork){
        .count = COUNT, .context = numbers, .tell = tell, .cost = cost, .draw = draw, .take = take
    };
}

static ItemRun with_threads(int threads)
{
    return (ItemRun){ .device = { .threads = threads } };
}

static void assert_all_taken(const Numbers *numbers)
{
    assert_int_equal(numbers->count, COUNT);
    for (uint32_t i = 0; i < COUNT; i++)
        assert_int_equal(numbers->taken[i], 1);
}

/* --- what is done ----------------------------------------------------------------------------- */

static void every_item_is_taken_once(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 5; threads += 2) {
        Numbers numbers = { .count = 0 };
        const ItemWork work = work_of(&numbers);
        const ItemRun run = with_threads(threads);
        GpError error = { "" };
        assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
        assert_all_taken(&numbers);
        assert_int_equal(numbers.drawn, COUNT);
    }
}

static void the_longest_is_drawn_first(void **state)
{
    (void)state;
    Numbers numbers = { .count = 0 };
    const ItemWork work = work_of(&numbers);
    const ItemRun run = with_threads(1);
    GpError error = { "" };
    assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
    for (uint32_t i = 1; i < COUNT; i++)
        assert_true(cost(NULL, numbers.order[i - 1]) >= cost(NULL, numbers.order[i]));
}

static void work_in_order_is_taken_in_order(void **state)
{
    (void)state;
    Numbers numbers = { .sleep_us = 300 };
    ItemWork work = work_of(&numbers);
    const ItemRun run = with_threads(4);
    GpError error = { "" };
    work.in_order = true;
    assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
    for (uint32_t i = 0; i < COUNT; i++)
        assert_int_equal(numbers.order[i], i);
}

static void items_are_drawn_twice_to_be_compared(void **state)
{
    (void)state;
    Numbers numbers = { .count = 0 };
    const ItemWork work = work_of(&numbers);
    ItemRun run = with_threads(3);
    GpError error = { "" };
    run.verify = 100;
    assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
    assert_all_taken(&numbers);
    assert_int_equal(numbers.drawn, 2 * COUNT);
    numbers = (Numbers){ .count = 0 };
    run.verify = 25;
    assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
    assert_all_taken(&numbers);
    assert_in_range(numbers.drawn, COUNT + 2, 2 * COUNT - 10);
}

/* What is measured has the machine for itself, whatever is drawn twice. */
static void measured_items_are_drawn_alone_by_all_threads(void **state)
{
    (void)state;
    for (int verify = 0; verify <= 100; verify += 50) {
        Numbers numbers = { .sleep_us = 200 };
        ItemWork work = work_of(&numbers);
        ItemRun run = with_threads(3);
        GpError error = { "" };
        run.verify = verify;
        work.measures = true;
        work.in_order = true;
        assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
        assert_all_taken(&numbers);
        assert_int_equal(numbers.most_at_once, 1);
        assert_int_equal(numbers.threads, 3);
        assert_true(numbers.drawn == COUNT || (verify > 0 && numbers.drawn > COUNT));
    }
}

/* --- what goes wrong -------------------------------------------------------------------------- */

static void drawings_that_differ_name_who_drew_them(void **state)
{
    (void)state;
    Numbers numbers = { .differs = true };
    const ItemWork work = work_of(&numbers);
    ItemRun run = with_threads(2);
    GpError error = { "" };
    run.verify = 100;
    assert_int_equal(items_run(&work, &run, &error), ITEMS_DIFFER);
    assert_int_equal(numbers.count, 0);
    assert_non_null(strstr(error.text, "number "));
    assert_non_null(strstr(error.text, "thread 1"));
    assert_non_null(strstr(error.text, "thread 2"));
}

static void a_failure_ends_the_run_and_names_the_item(void **state)
{
    (void)state;
    Numbers numbers = { .fails = 8 };
    const ItemWork work = work_of(&numbers);
    const ItemRun run = with_threads(2);
    GpError error = { "" };
    assert_int_equal(items_run(&work, &run, &error), ITEMS_INPUT);
    assert_string_equal(error.text, "number 7: nothing to read");
    assert_int_equal(numbers.taken[7], 0);
    numbers = (Numbers){ .breaks = 8 };
    assert_int_equal(items_run(&work, &run, &error), ITEMS_INTERNAL);
    assert_string_equal(error.text, "the disk is full");
}

static void a_device_that_is_not_here_is_refused_before_anything_is_drawn(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 3; threads += 2) {
        Numbers numbers = { .count = 0 };
        const ItemWork work = work_of(&numbers);
        ItemRun run = with_threads(threads);
        GpError error = { "" };
        run.device.isa = "nope";
        assert_int_equal(items_run(&work, &run, &error), ITEMS_USAGE);
        assert_non_null(strstr(error.text, "nope"));
        assert_int_equal(numbers.drawn, 0);
    }
}

static void an_item_that_takes_too_long_is_named(void **state)
{
    (void)state;
    static Numbers numbers = { .sleep_us = 700000 }; /* its thread outlives the test */
    static ItemWork work;
    ItemRun run = with_threads(1);
    GpError error = { "" };
    work = work_of(&numbers);
    run.timeout = 0.05;
    assert_int_equal(items_run(&work, &run, &error), ITEMS_INTERNAL);
    assert_non_null(strstr(error.text, "thread 1 has not drawn it in 0.05 s"));
}

/* --- journals --------------------------------------------------------------------------------- */

static char journal[] = "/tmp/glasspipe-test-journal-XXXXXX";

/* A run that ends at item 8 leaves what it has done; returns how many. */
static uint32_t begin_run(const ItemWork *work, Numbers *numbers, const ItemRun *run)
{
    GpError error = { "" };
    unlink(journal);
    *numbers = (Numbers){ .fails = 8 };
    assert_int_equal(items_run(work, run, &error), ITEMS_INPUT);
    assert_int_equal(access(journal, F_OK), 0);
    return numbers->count;
}

static void a_run_goes_on_from_its_journal(void **state)
{
    (void)state;
    Numbers numbers;
    const ItemWork work = work_of(&numbers);
    ItemRun run = with_threads(1);
    GpError error = { "" };
    run.journal = journal;
    run.resume = true;
    run.key = 5;
    const uint32_t done = begin_run(&work, &numbers, &run);
    assert_in_range(done, 1, COUNT - 1);
    numbers = (Numbers){ .count = 0 };
    assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
    assert_all_taken(&numbers);
    assert_int_equal(numbers.drawn, COUNT - done);
    assert_int_not_equal(access(journal, F_OK), 0);
}

/* Ended at any byte, as by a signal: what is whole counts, and the rest is drawn. */
static void a_journal_may_end_anywhere(void **state)
{
    (void)state;
    Numbers numbers;
    const ItemWork work = work_of(&numbers);
    ItemRun run = with_threads(1);
    GpError error = { "" };
    run.journal = journal;
    run.resume = true;
    begin_run(&work, &numbers, &run);
    FILE *file = fopen(journal, "rb");
    fseek(file, 0, SEEK_END);
    const long size = ftell(file);
    fclose(file);
    for (long cut = 1; cut < size - 40; cut += 37) {
        begin_run(&work, &numbers, &run);
        assert_int_equal(truncate(journal, size - cut), 0);
        numbers = (Numbers){ .count = 0 };
        assert_int_equal(items_run(&work, &run, &error), ITEMS_DONE);
        assert_all_taken(&numbers);
    }
}

static void a_journal_of_other_work_is_refused(void **state)
{
    (void)state;
    Numbers numbers;
    const ItemWork work = work_of(&numbers);
    ItemRun run = with_threads(1);
    GpError error = { "" };
    run.journal = journal;
    run.resume = true;
    begin_run(&work, &numbers, &run);
    run.key = 6;
    assert_int_equal(items_run(&work, &run, &error), ITEMS_INPUT);
    assert_non_null(strstr(error.text, "of other work"));
    FILE *file = fopen(journal, "wb");
    fputs("something else", file);
    fclose(file);
    assert_int_equal(items_run(&work, &run, &error), ITEMS_INPUT);
    assert_non_null(strstr(error.text, "no journal"));
    unlink(journal);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_item_is_taken_once),
        cmocka_unit_test(the_longest_is_drawn_first),
        cmocka_unit_test(work_in_order_is_taken_in_order),
        cmocka_unit_test(items_are_drawn_twice_to_be_compared),
        cmocka_unit_test(measured_items_are_drawn_alone_by_all_threads),
        cmocka_unit_test(drawings_that_differ_name_who_drew_them),
        cmocka_unit_test(a_failure_ends_the_run_and_names_the_item),
        cmocka_unit_test(a_device_that_is_not_here_is_refused_before_anything_is_drawn),
        cmocka_unit_test(an_item_that_takes_too_long_is_named),
        cmocka_unit_test(a_run_goes_on_from_its_journal),
        cmocka_unit_test(a_journal_may_end_anywhere),
        cmocka_unit_test(a_journal_of_other_work_is_refused),
    };
    const int handle = mkstemp(journal);
    if (handle >= 0)
        close(handle);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
