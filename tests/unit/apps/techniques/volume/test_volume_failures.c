/* How pictures of volumes fail, each failure beside its remedy, as rows of a table. */
#include "apps/techniques/volume/technique.h"
#include "tests/support/technique_case.h"
#include "tests/support/unit.h"

static void check(const TechniqueCase *rows, size_t count)
{
    GpError error;
    if (technique_cases_check(&volume_technique, rows, count, &error))
        fail_msg("%s", error.text);
}

#define BALL "builtin:ball:48"

static void what_splats_lose_is_found_again(void **state)
{
    (void)state;
    static const TechniqueCase rows[] = {
        { "splats are near the data", BALL, "--method splat", "decibels", 34, 60 },
        { "wide kernels blur it", BALL, "--method splat --deviation 2", "decibels", 10, 28 },
        { "the filter alone leaves gaps", BALL, "--method splat --filter lowpass --lowpass 0.3",
          "decibels", 5, 25 },
    };
    check(rows, GP_COUNT(rows));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_splats_lose_is_found_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
