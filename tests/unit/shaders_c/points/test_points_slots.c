/* What the shaders of points cost: within the profiles that they name, and beside paper 003's 49 slots of
 * EWA, 40 of reconstruction alone and 32 of the low-pass filter alone, vertex and pixel shader together: ours
 * project without tangents, but shade waves and edges as well. */
#include "pipeline/shader/counts.h"
#include "shaders_c/points/compressed_splat.h"
#include "shaders_c/points/disc.h"
#include "shaders_c/points/normalize.h"
#include "shaders_c/points/perspective.h"
#include "shaders_c/points/quad.h"
#include "shaders_c/points/sequence.h"
#include "shaders_c/points/splat.h"
#include "shaders_c/points/ternary.h"
#include "tests/support/unit.h"

static const struct {
    const GpProgram *program;
    int vertex, pixel; /* slots at most: what they take today; the last passes a little more */
} rows[] = {
#define ROW(name, vertex, pixel)                                                                   \
    {                                                                                              \
        &name##_program, vertex, pixel                                                             \
    }
    ROW(splat_visibility, 78, 12),
    ROW(splat_color, 98, 12),
    ROW(splat_surface, 101, 13),
    ROW(ternary_color, 97, 12),
    ROW(ternary_surface, 100, 13),
    ROW(perspective_visibility, 102, 26),
    ROW(perspective_color, 155, 20),
    ROW(perspective_surface, 158, 25),
    ROW(quad_visibility, 117, 7),
    ROW(quad_color, 134, 7),
    ROW(quad_surface, 134, 8),
    ROW(splat_normalize, 1, 256),
    ROW(splat_shade, 1, 400),
    ROW(point_pixel, 29, 1),
    ROW(point_round, 34, 6),
    ROW(lit_round, 38, 6),
    ROW(lit_square, 37, 1),
    ROW(sequence_square, 43, 1),
    ROW(compressed_visibility, 122, 12),
    ROW(compressed_color, 145, 12),
    ROW(compressed_surface, 148, 13),
    ROW(printed_visibility, 123, 12),
    ROW(printed_color, 149, 12),
    ROW(printed_surface, 152, 13),
};

static void shaders_stay_within_profiles_and_slots(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const GpProgram *program = rows[i].program;
        GpShaderCounts vertex = { 0 }, pixel = { 0 };
        GpError error = { "" };
        if (gp_program_check(program, &error))
            fail_msg("%s", error.text);
        if (!program->count)
            skip();
        program->count(program, &vertex, &pixel);
        print_message("# %s: %d slots, %d registers; %d slots, %d registers\n", program->name,
                      vertex.slots, vertex.temporaries, pixel.slots, pixel.temporaries);
        failed += vertex.slots > rows[i].vertex || pixel.slots > rows[i].pixel;
    }
    assert_int_equal(failed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shaders_stay_within_profiles_and_slots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
