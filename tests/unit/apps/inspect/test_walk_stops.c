/* Where a walk through a list stops: every draw once, in order, in as many stops as there may
 * be. */
#include "apps/inspect/walk.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { MOST_PASSES = 12 };

/* A list of empty draws; of half the passes a few, of the others up to `most`. */
static void make_list(Random *random, int32_t most, GpPass passes[MOST_PASSES], GpList *list)
{
    static const GpOrder orders[] = { GP_ORDER_SUBMITTED, GP_ORDER_SUBMITTED, GP_ORDER_DEPTH };
    *list =
        (GpList){ .passes = passes, .pass_count = (uint32_t)random_int(random, 1, MOST_PASSES) };
    for (uint32_t p = 0; p < list->pass_count; p++)
        passes[p] = (GpPass){ .draw_count = (uint32_t)random_int(
                                  random, 0, random_int(random, 0, 1) ? 2 : most),
                              .order = orders[random_int(random, 0, 2)] };
}

static void check_pass(const GpPass *pass, uint32_t number, uint32_t most_draws,
                       const WalkStop **stop)
{
    const WalkStop *first = *stop;
    uint32_t draws = 0;
    do {
        assert_int_equal((*stop)->pass, number);
        assert_int_equal((*stop)->first, draws);
        draws += (*stop)->count;
        if (pass->order == GP_ORDER_SUBMITTED)
            assert_in_range((*stop)->count, pass->draw_count ? 1 : 0, most_draws);
        else
            assert_int_equal((*stop)->count, pass->draw_count);
        (*stop)++;
    } while (draws < pass->draw_count);
    assert_int_equal(draws, pass->draw_count);
    if (pass->order == GP_ORDER_SUBMITTED && pass->draw_count)
        assert_int_equal(*stop - first, (pass->draw_count + most_draws - 1) / most_draws);
}

static void stops_part_a_list_into_its_draws(void **state)
{
    (void)state;
    Random random = { 21 };
    for (int i = 0; i < 2000; i++) {
        static const int32_t most[] = { 3, 20, 300, 5000 };
        GpPass passes[MOST_PASSES];
        GpList list;
        WalkStop stops[WALK_MOST_STOPS + MOST_PASSES];
        make_list(&random, most[i % 4], passes, &list);
        uint32_t draws = 0;
        for (uint32_t p = 0; p < list.pass_count; p++)
            draws += passes[p].draw_count;
        const uint32_t count = walk_stops(&list, NULL);
        assert_in_range(count, list.pass_count, WALK_MOST_STOPS + list.pass_count);
        assert_int_equal(walk_stops(&list, stops), count);
        const WalkStop *stop = stops;
        for (uint32_t p = 0; p < list.pass_count; p++)
            check_pass(&passes[p], p, (draws + WALK_MOST_STOPS - 1) / WALK_MOST_STOPS, &stop);
        assert_int_equal(stop - stops, count);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stops_part_a_list_into_its_draws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
