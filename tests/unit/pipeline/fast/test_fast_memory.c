/* The fast executor with next to no memory for vertices and bins: what is there is drawn before more
 * is made, and the bits stay the same; so with next to none for fragments to be sorted, where tiles
 * come in slices, and in passes that repeat earlier ones. */
#include "pipeline/fast/fast.h"
#include "tests/support/lists/random_order.h"
#include "tests/support/lists/random_repeats.h"
#include "tests/support/unit.h"

#include "pipeline/base/fpcontrol.h"

enum { SEEDS = 150, SIZE = 150, LANES = 4 /* always compiled */ };

static uint64_t draw(uint64_t seed, bool sorted, int threads, size_t limit, RandomList *random)
{
    GpFast *fast = NULL;
    GpCounters counters = { 0 };
    GpPhases phases = { 0 };
    assert_true(random_list_create(seed, SIZE, random));
    assert_true(!sorted || random_order_add(seed, random));
    if (seed % 2 && !sorted)
        random_repeats_add(seed, random);
    assert_int_equal(gp_fast_create(threads, &fast, NULL), GP_OK);
    if (limit)
        gp_fast_set_limit(fast, limit);
    GpFpControl control = gp_fp_enter();
    assert_int_equal(gp_fast_run(fast, &random->list, LANES, false, &counters, &phases, NULL),
                     GP_OK);
    gp_fp_leave(control);
    gp_fast_destroy(&fast);
    uint64_t hash = random_list_hash(random);
    random_list_destroy(random);
    return hash;
}

static void memory_limit_changes_no_bit(void **state)
{
    (void)state;
    static const size_t limits[] = { 1, 3000, 100000 };
    RandomList *random = gp_alloc(1, sizeof *random);
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        const bool sorted = seed % 32 == 15; /* a second each, with the least for fragments */
        uint64_t whole = draw(seed, sorted, 1, 0, random);
        for (size_t i = 0; i < (sorted ? 1 : GP_COUNT(limits)); i++)
            assert_true(draw(seed, sorted, 1 + (int)(seed % 3), limits[i], random) == whole);
    }
    gp_free(random);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_limit_changes_no_bit),
    };
    return cmocka_run_group_tests_name("fast memory", tests, NULL, NULL);
}
