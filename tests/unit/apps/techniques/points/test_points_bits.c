/* The bits of splatted pictures: one picture for every executor, number of threads and lane
 * width. */
#include "apps/techniques/points/options.h"
#include "apps/techniques/points/technique.h"
#include "tests/support/technique/one_picture.h"
#include "tests/support/unit.h"

enum { SIDE = 64 };

/* lit: two sums, and a picture's depth */
static void check(const char *model, bool unlit, uint64_t hashes[SWEEP_ROWS])
{
    PointsOptions options = points_option_defaults;
    options.sharp = 40; /* of use to a cube's edges */
    options.color = unlit ? "waves:20" : "gold";
    const TechniqueInput input = {
        .path = model, .width = SIDE, .height = SIDE, .setting = &options
    };
    sweep_is_one_picture(&points_technique, &input, hashes);
}

static void every_method_of_the_sweep_is_one_picture(void **state)
{
    (void)state;
    uint64_t unlit[SWEEP_ROWS], lit[SWEEP_ROWS];
    check("builtin:torus", true, unlit);
    check("builtin:torus", false, lit);
    assert_true(lit[0] != unlit[0]); /* or nothing was compared */
}

static void clip_lines_are_one_picture(void **state)
{
    (void)state;
    uint64_t unlit[SWEEP_ROWS], lit[SWEEP_ROWS];
    check("builtin:cube", true, unlit);
    check("builtin:cube", false, lit);
    assert_true(lit[0] != unlit[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_of_the_sweep_is_one_picture),
        cmocka_unit_test(clip_lines_are_one_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
