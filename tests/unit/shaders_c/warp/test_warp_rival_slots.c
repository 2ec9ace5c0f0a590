/* What the shaders of depth images' rivals cost: within the profiles that they name. */
#include "shaders_c/warp/displacement.h"
#include "shaders_c/warp/parallax.h"
#include "shaders_c/warp/relief.h"
#include "shaders_c/warp/relief_texture.h"
#include "tests/support/slots.h"

static const SlotsRow rows[] = {
    SLOTS_ROW(relief, 3, 198),
    SLOTS_ROW(relief_lit, 5, 233),
    SLOTS_ROW(displacement, 3, 262),
    SLOTS_ROW(displacement_lit, 5, 297),
    SLOTS_ROW(relief_texture, 6, 38),
    SLOTS_ROW(relief_texture_lit, 6, 98),
    SLOTS_ROW(bump, 6, 28),
    SLOTS_ROW(bump_lit, 6, 62),
    SLOTS_ROW(parallax, 6, 38),
    SLOTS_ROW(parallax_lit, 6, 72),
    SLOTS_ROW(parallax_limited, 6, 43),
    SLOTS_ROW(parallax_limited_lit, 6, 77),
};

static void shaders_stay_within_profiles_and_slots(void **state)
{
    (void)state;
    check_slots(rows, GP_COUNT(rows));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shaders_stay_within_profiles_and_slots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
