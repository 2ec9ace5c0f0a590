/* The bits of pictures of volumes: one picture for every executor, number of threads and lane
 * width. */
#include "apps/techniques/volume/options.h"
#include "apps/techniques/volume/technique.h"
#include "tests/support/technique/one_picture.h"
#include "tests/support/unit.h"

enum { SIDE = 64 };

static void check(const char *volume, const VolumeOptions *options, uint64_t hashes[SWEEP_ROWS])
{
    const TechniqueInput input = {
        .path = volume, .width = SIDE, .height = SIDE, .setting = options
    };
    sweep_is_one_picture(&volume_technique, &input, hashes);
}

static void every_method_of_the_sweep_is_one_picture(void **state)
{
    (void)state;
    uint64_t unlit[SWEEP_ROWS], lit[SWEEP_ROWS];
    VolumeOptions options = volume_option_defaults;
    check("builtin:marschner-lobb:14", &options, unlit);
    options.lit = true;
    options.orbit.azimuth = 200;
    check("builtin:ball:14", &options, lit);
    assert_true(lit[0] != unlit[0]); /* or nothing was compared */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_of_the_sweep_is_one_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
