/* What the shaders of points cost: within the profiles that they name, and beside paper 003's 49
 * slots of EWA, 40 of reconstruction alone and 32 of the low-pass filter alone, vertex and pixel
 * shader together: ours project without tangents, but shade waves and edges as well. */
#include "shaders_c/points/compressed_splat.h"
#include "shaders_c/points/disc.h"
#include "shaders_c/points/normalize.h"
#include "shaders_c/points/perspective.h"
#include "shaders_c/points/quad.h"
#include "shaders_c/points/sequence.h"
#include "shaders_c/points/splat.h"
#include "shaders_c/points/ternary.h"
#include "tests/support/slots.h"

static const SlotsRow rows[] = {
    SLOTS_ROW(splat_visibility, 78, 12),
    SLOTS_ROW(splat_color, 98, 12),
    SLOTS_ROW(splat_surface, 101, 13),
    SLOTS_ROW(ternary_color, 97, 12),
    SLOTS_ROW(ternary_surface, 100, 13),
    SLOTS_ROW(perspective_visibility, 102, 26),
    SLOTS_ROW(perspective_color, 155, 20),
    SLOTS_ROW(perspective_surface, 158, 25),
    SLOTS_ROW(quad_visibility, 117, 7),
    SLOTS_ROW(quad_color, 134, 7),
    SLOTS_ROW(quad_surface, 134, 8),
    SLOTS_ROW(splat_normalize, 1, 256),
    SLOTS_ROW(splat_shade, 1, 400),
    SLOTS_ROW(point_pixel, 29, 1),
    SLOTS_ROW(point_round, 34, 6),
    SLOTS_ROW(lit_round, 38, 6),
    SLOTS_ROW(lit_square, 37, 1),
    SLOTS_ROW(sequence_square, 43, 1),
    SLOTS_ROW(compressed_visibility, 122, 12),
    SLOTS_ROW(compressed_color, 145, 12),
    SLOTS_ROW(compressed_surface, 148, 13),
    SLOTS_ROW(printed_visibility, 123, 12),
    SLOTS_ROW(printed_color, 149, 12),
    SLOTS_ROW(printed_surface, 152, 13),
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
