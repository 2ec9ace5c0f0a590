/* Errands: all are done, one after the other, in the order in which they were given. */
#include "apps/base/errands.h"
#include "tests/support/unit.h"

#include <stdlib.h>

enum { MOST = 1000 };

typedef struct Done {
    int numbers[MOST], count;
} Done;

typedef struct Note {
    Done *done;
    int number;
} Note;

static void note(void *context)
{
    Note *own = context;
    own->done->numbers[own->done->count++] = own->number;
    free(own);
}

static void give(Errands *errands, Done *done, int number)
{
    Note *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (Note){ done, number };
    errands_give(errands, note, own);
}

static void check(const Done *done, int count)
{
    assert_int_equal(done->count, count);
    for (int i = 0; i < count; i++)
        assert_int_equal(done->numbers[i], i);
}

static void errands_are_done_in_order_before_the_wait_ends(void **state)
{
    (void)state;
    Done done = { .count = 0 };
    Errands *errands = errands_begin();
    assert_non_null(errands);
    errands_wait(errands); /* for none */
    for (int i = 0; i < MOST; i++) {
        give(errands, &done, i);
        if (i % 100 == 7) {
            errands_wait(errands);
            check(&done, i + 1);
        }
    }
    errands_end(&errands); /* with some to do */
    check(&done, MOST);
    assert_null(errands);
    errands_end(&errands);
}

static void without_a_thread_they_are_done_as_they_are_given(void **state)
{
    (void)state;
    Done done = { .count = 0 };
    for (int i = 0; i < 5; i++) {
        give(NULL, &done, i);
        check(&done, i + 1);
    }
    errands_wait(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errands_are_done_in_order_before_the_wait_ends),
        cmocka_unit_test(without_a_thread_they_are_done_as_they_are_given),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
