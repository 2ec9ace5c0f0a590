/* How warped pictures fail, each failure beside its remedy. What grids, edges, seams and orders of
 * drawing do has tests where they are drawn. */
#include "apps/techniques/warp/technique.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

static void check(const TechniqueCase *rows, size_t count)
{
    GpError error;
    if (technique_cases_check(&warp_technique, rows, count, &error))
        fail_msg("%s", error.text);
}

#define POT   "builtin:teapot"
#define SMALL " --source-size 256x256"

static void searches_too_coarse_pass_thin_things(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "64 steps", POT, "--method relief" SMALL, "decibels", 30, 60 },
        { "3 steps", POT, "--method relief --search 3" SMALL, "decibels", 5, 28 },
        { "64 steps end at edges", POT, "--method relief" SMALL, "extra", 0, 200 },
        { "3 steps do not", POT, "--method relief --search 3" SMALL, "extra", 2000, 9000 },
    };
    check(rows, GP_COUNT(rows));
}

/* As the table of depths of 8 bits has them, and fewer. */
static void depths_of_few_bits_are_stairs(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "4096 entries", POT, "--method planar" SMALL, "depth", 0, 0.005 },
        { "32 entries", POT, "--method planar --entries 32" SMALL, "depth", 0.01, 1 },
        { "8 entries", POT, "--method planar --entries 8" SMALL, "depth", 0.08, 1 },
    };
    check(rows, GP_COUNT(rows));
}

static void larger_steps_lose_what_is_small(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "every pixel", POT, "--method layers --step 1" SMALL, "decibels", 28, 60 },
        { "every 16th", POT, "--method layers --step 16" SMALL, "decibels", 5, 25 },
    };
    check(rows, GP_COUNT(rows));
}

/* Pictures on rectangles look as if, but for their outlines. */
static void look_alikes_move_no_outline(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "bump mapping", POT, "--method bump" SMALL, "missing", 2000, 9000 },
        { "parallax mapping", POT, "--method parallax" SMALL, "missing", 2000, 9000 },
        { "is nearer inside", POT, "--method parallax" SMALL, "decibels", 25, 60 },
        { "than bump mapping", POT, "--method bump" SMALL, "decibels", 5, 23 },
        { "relief textures move them", POT, "--method relief-texture --cut none" SMALL, "missing",
          0, 1800 },
    };
    check(rows, GP_COUNT(rows));
}

/* From 20 degrees to the left the handle is no longer before the body. */
static void sheets_are_cut_and_holes_are_filled(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "rubber sheets", POT, "--method planar --turn -20" SMALL, "mean depth", 0.011, 0.03 },
        { "cut", POT, "--method direct --turn -20" SMALL, "mean depth", 0, 0.009 },
        { "as printed too", POT, "--method planar --cut slopes --turn -20" SMALL, "mean depth", 0,
          0.009 },
        { "with holes", POT, "--method direct --turn -20" SMALL, "missing", 2500, 4000 },
        { "which are filled", POT, "--method layers --turn -20" SMALL, "missing", 0, 1800 },
    };
    check(rows, GP_COUNT(rows));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(searches_too_coarse_pass_thin_things),
        cmocka_unit_test(depths_of_few_bits_are_stairs),
        cmocka_unit_test(larger_steps_lose_what_is_small),
        cmocka_unit_test(look_alikes_move_no_outline),
        cmocka_unit_test(sheets_are_cut_and_holes_are_filled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
