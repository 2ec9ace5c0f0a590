/* The tree of neighbours finds what comparing with all points finds, in the same order. */
#define POOL_THREADS 3
#include "apps/points/cloud/neighbours.h"
#include "tests/support/groups/pool.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <string.h>

enum { MOST_POINTS = 3000 };

static float positions[3 * MOST_POINTS];

/* Of all points but one, by distance and number; found: numbers. */
static uint32_t find_slowly(uint32_t count, const float place[3], uint32_t except, uint32_t most,
                            Neighbour *found)
{
    uint32_t taken = 0;
    for (uint32_t i = 0; i < count; i++) {
        double distance2 = 0;
        for (size_t k = 0; k < 3; k++) {
            const double d = (double)positions[3 * i + k] - (double)place[k];
            distance2 = k == 0 ? d * d : distance2 + d * d;
        }
        if (i == except)
            continue;
        uint32_t at = taken;
        while (at > 0 && distance2 < found[at - 1].distance2)
            at--;
        if (at == most)
            continue;
        taken += taken < most;
        memmove(found + at + 1, found + at, (taken - at - 1) * sizeof *found);
        found[at] = (Neighbour){ .distance2 = distance2, .rank = i };
    }
    return taken;
}

static bool is_same(const Neighbour *a, const Neighbour *b, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        if (a[i].rank != b[i].rank || a[i].distance2 != b[i].distance2)
            return false;
    return true;
}

static void assert_finds_the_same(uint32_t count, uint32_t most)
{
    NeighbourTree tree;
    assert_int_equal(neighbour_tree_build(positions, count, pool, &tree), GP_OK);
    Neighbour walked[NEIGHBOURS_MOST]; /* each bounded by the one before */
    for (uint32_t rank = 0, known = 0; rank < count; rank++) {
        Neighbour found[NEIGHBOURS_MOST], expected[NEIGHBOURS_MOST];
        const float *place = tree.positions + 3 * (size_t)rank;
        const uint32_t of = neighbours_of(&tree, rank, most, 0, found);
        assert_int_equal(of, find_slowly(count, place, tree.numbers[rank], most, expected));
        known = neighbours_of(&tree, rank, most, known, walked);
        assert_int_equal(known, of);
        assert_true(is_same(found, walked, of));
        for (uint32_t i = 0; i < of; i++) {
            if (tree.numbers[found[i].rank] != expected[i].rank ||
                found[i].distance2 != expected[i].distance2)
                fail_msg("%u points, %u sought: neighbour %u of %u is %u, not %u", count, most, i,
                         rank, tree.numbers[found[i].rank], expected[i].rank);
        }
    }
    neighbour_tree_free(&tree);
}

static void every_search_finds_what_comparing_with_all_finds(void **state)
{
    (void)state;
    static const uint32_t counts[] = { 1, 2, 7, 8, 31, 32, 100, 1000, MOST_POINTS };
    Random random = { .state = 77 };
    for (int kind = 0; kind < 4; kind++) {
        for (size_t i = 0; i < 3 * MOST_POINTS; i++) {
            const float anywhere = random_float(&random, -1, 1);
            positions[i] = kind == 0   ? anywhere
                           : kind == 1 ? (float)random_int(&random, 0, 9)    /* many ties */
                           : kind == 2 ? (i % 3 == 1 ? 3 : anywhere * 1e-4F) /* flat and small */
                                       : 5;                                  /* one place */
        }
        for (size_t c = 0; c < GP_COUNT(counts); c++)
            assert_finds_the_same(counts[c], c % 2 ? 16 : 5);
    }
}

static void the_tree_does_not_depend_on_the_threads(void **state)
{
    (void)state;
    Random random = { .state = 3 };
    for (size_t i = 0; i < 3 * MOST_POINTS; i++)
        positions[i] = (float)random_int(&random, 0, 40);
    GpPool *one;
    NeighbourTree a, b;
    assert_int_equal(gp_pool_create(1, &one, NULL), GP_OK);
    assert_int_equal(neighbour_tree_build(positions, MOST_POINTS, pool, &a), GP_OK);
    assert_int_equal(neighbour_tree_build(positions, MOST_POINTS, one, &b), GP_OK);
    assert_memory_equal(a.numbers, b.numbers, MOST_POINTS * sizeof *a.numbers);
    assert_memory_equal(a.positions, b.positions, 3 * MOST_POINTS * sizeof *a.positions);
    neighbour_tree_free(&a);
    neighbour_tree_free(&b);
    gp_pool_destroy(&one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_search_finds_what_comparing_with_all_finds),
        cmocka_unit_test(the_tree_does_not_depend_on_the_threads),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
