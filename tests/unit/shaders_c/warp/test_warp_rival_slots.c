/* What the shaders of depth images' rivals cost: within the profiles that they name. */
#include "pipeline/shader/counts.h"
#include "shaders_c/warp/displacement.h"
#include "shaders_c/warp/parallax.h"
#include "shaders_c/warp/relief.h"
#include "shaders_c/warp/relief_texture.h"
#include "tests/support/unit.h"

static const struct {
    const GpProgram *program;
    int vertex, pixel; /* slots at most: what they take today */
} rows[] = {
#define ROW(name, vertex, pixel)                                                                   \
    {                                                                                              \
        &name##_program, vertex, pixel                                                             \
    }
    ROW(relief, 3, 198),
    ROW(relief_lit, 5, 233),
    ROW(displacement, 3, 262),
    ROW(displacement_lit, 5, 297),
    ROW(relief_texture, 6, 38),
    ROW(relief_texture_lit, 6, 98),
    ROW(bump, 6, 28),
    ROW(bump_lit, 6, 62),
    ROW(parallax, 6, 38),
    ROW(parallax_lit, 6, 72),
    ROW(parallax_limited, 6, 43),
    ROW(parallax_limited_lit, 6, 77),
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
