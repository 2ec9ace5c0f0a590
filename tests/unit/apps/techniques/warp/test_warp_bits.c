/* The bits of warped pictures: one picture for every executor, number of threads and lane width. */
#include "apps/techniques/warp/options.h"
#include "apps/techniques/warp/technique.h"
#include "tests/support/technique/one_picture.h"
#include "tests/support/unit.h"

enum { SIDE = 64 };

static void check(const char *model, const char *color, uint64_t hashes[SWEEP_ROWS])
{
    WarpOptions options = warp_option_defaults;
    options.color = color;
    options.source_size[0] = 48;
    options.source_size[1] = 56;
    const TechniqueInput input = {
        .path = model, .width = SIDE, .height = SIDE, .setting = &options
    };
    sweep_is_one_picture(&warp_technique, &input, hashes);
}

static void every_method_of_the_sweep_is_one_picture(void **state)
{
    (void)state;
    uint64_t unlit[SWEEP_ROWS], lit[SWEEP_ROWS];
    check("builtin:torus", "waves:8", unlit);
    check("builtin:torus", NULL, lit);
    assert_true(lit[0] != unlit[0]); /* or nothing was compared */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_of_the_sweep_is_one_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
