/* A model without memory: it says so, and can be used later. */
#include "apps/techniques/points/model.h"
#include "apps/techniques/points/technique.h"
#include "tests/support/limited.h"
#include "tests/support/unit.h"

#include <sys/resource.h>

enum { SIDE = 16, THREADS = 4, LARGEST = 1 << 20, LEAST = 32 /* bytes */ };

/* All memory that there is, as a list of pieces. */
static void *take_memory(void)
{
    void *list = NULL;
    for (size_t size = LARGEST; size >= LEAST; size /= 2)
        for (void *piece; (piece = malloc(size)); list = piece)
            *(void **)piece = list;
    return list;
}

static void give_memory(void *list)
{
    while (list) {
        void *piece = list;
        list = *(void **)piece;
        free(piece);
    }
}

/* What a function leaves unset is then no NULL. */
__attribute__((noinline)) static void fill_stack(void)
{
    volatile char junk[16384];
    for (size_t i = 0; i < sizeof junk; i++)
        junk[i] = 0x5a;
}

static void threads_that_cannot_be_made_are_told(void **state)
{
    (void)state;
    PointsOptions options = { .subdivide = 0 };
    const TechniqueInput input = {
        .path = "builtin:cube", .width = SIDE, .height = SIDE, .setting = &options
    };
    GpError error;
    void *opened;
    struct rlimit before, none;
    assert_int_equal(points_technique.open(&input, &opened, &error), GP_OK);
    assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
    none = before;
    none.rlim_cur = 0;
    if (limits_hold()) {
        assert_int_equal(setrlimit(RLIMIT_AS, &none), 0);
        void *taken = take_memory();
        fill_stack();
        const GpResult structure = points_model_structure(opened, POINTS_PLAIN, THREADS, &error);
        fill_stack();
        const GpResult truth = points_model_truth(opened, THREADS, &error);
        give_memory(taken);
        assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
        assert_int_equal(structure, GP_ERROR_MEMORY);
        assert_int_equal(truth, GP_ERROR_MEMORY);
    }
    assert_int_equal(points_model_structure(opened, POINTS_PLAIN, THREADS, &error), GP_OK);
    assert_int_equal(points_model_truth(opened, THREADS, &error), GP_OK);
    points_technique.close(opened);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_that_cannot_be_made_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
