/* What the floor of a frame is made of: operations as counted by hand. */
#include "apps/bench/cases.h"
#include "apps/bench/operations.h"
#include "tests/support/unit.h"

typedef struct Counted {
    const char *name;
    double vertex, fragment;
} Counted;

enum {
    WEIGHTS = 9 + 4, /* edges, shares, a division; and with perspective */
    DEPTH = 6,
    STORE_8 = 4 * 3, /* clamp, scale, round */
};

static void operations_are_those_of_the_definitions(void **state)
{
    (void)state;
    static const Counted rows[] = {
        /* four colours, interpolated and scaled; replaced */
        { "fill_nozs", 0, WEIGHTS + 4 * 4 + 4 + STORE_8 },
        /* source times alpha, target times the rest, a sum, the target's code to a number */
        { "fill_blend", 0, WEIGHTS + 4 * 4 + 4 + STORE_8 + 4 * (1 + 2 + 1 + 1) },
        { "fill_blend32f", 0, WEIGHTS + 4 * 4 + 4 + 4 * (1 + 1 + 1) },
        /* coordinates; a texel, compared, and the fragment killed or not; its two addresses */
        { "discard_tex", 0, WEIGHTS + 4 * 2 + 4 + 1 + 1 + 2 * 4 + DEPTH + STORE_8 },
        /* 64 steps of eight chains of two: mad; halves and quarters, squares; sums and their
         * quarter */
        { "alu_mad", 0, WEIGHTS + 2 * 4 + 2 + 2 * (64 * 4 * 2 * 2 + 3 * 2 + 4 * 2) + STORE_8 },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const BenchCase *bench = bench_case_find(rows[i].name);
        Frame frame = { .color = NULL };
        GpError error = { "" };
        assert_int_equal(bench->build(bench, &frame, &error), GP_OK);
        const GpPass *pass = &frame.list.passes[frame.list.pass_count - 1];
        const DrawOperations counted = draw_operations(pass, &pass->draws[0]);
        if (counted.vertex != rows[i].vertex || counted.fragment != rows[i].fragment)
            fail_msg("%s: %g a vertex, %g a fragment; by hand %g and %g", rows[i].name,
                     counted.vertex, counted.fragment, rows[i].vertex, rows[i].fragment);
        frame_free(&frame);
    }
}

/* Where no colour is written, and nothing discards, fragments cost nothing; a position's three rows
 * of four and the fourth are products and sums. */
static void depth_alone_shades_no_fragment(void **state)
{
    (void)state;
    const BenchCase *bench = bench_case_find("grid_depth");
    Frame frame = { .color = NULL };
    GpError error = { "" };
    assert_int_equal(bench->build(bench, &frame, &error), GP_OK);
    const GpPass *pass = &frame.list.passes[frame.list.pass_count - 1];
    const DrawOperations counted = draw_operations(pass, &pass->draws[0]);
    assert_true(counted.fragment == 0);
    assert_true(counted.vertex == 4 * 7);
    frame_free(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operations_are_those_of_the_definitions),
        cmocka_unit_test(depth_alone_shades_no_fragment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
