/* Targets that no cache holds, which are stored around the caches where rows begin at whole
 * vectors, and only there: rows of any length, at any place in the caller's memory. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

enum { ROWS = 65, PITCH = 1 << 16, TEXEL = 4, CORNER_FLOATS = 10, GAP = 0xa5, LARGE = 4 << 20 };

/* Clears and draws into memory whose texels begin `offset` bytes from a whole vector: small, it
 * leaves tiles that are only cleared. */
static void draw_at(uint8_t *memory, size_t offset, uint32_t width, size_t pitch, bool is_small)
{
    static const float corners[3][CORNER_FLOATS] = { { -1, 1, 0, 1, 1, 0.2f, 0.7f, 0.4f, 0, 0 },
                                                     { 2, 1, 0, 1, 0, 0.9f, 0.1f, 1, 0, 0 },
                                                     { -1, -2, 0, 1, 1, 1, 0.3f, 0.6f, 0, 0 } };
    ExerciseUniforms uniforms = { .color = { 0.25f, 0, 0.125f, 0 } };
    for (int i = 0; i < 4; i++)
        uniforms.matrix[i][i] = 1;
    GpDraw draw = { .program = &exercise_color, .uniforms = &uniforms };
    if (is_small)
        draw.viewport = (GpViewport){ .width = 5, .height = 3 };
    draw.geometry.vertex_count = 3;
    draw.geometry.streams[GP_POSITION] = (GpStream){ corners[0], sizeof corners[0], 4, GP_FLOAT32 };
    draw.geometry.streams[GP_COLOR] =
        (GpStream){ corners[0] + 4, sizeof corners[0], 4, GP_FLOAT32 };
    draw.geometry.streams[GP_TEXCOORD0] =
        (GpStream){ corners[0] + 8, sizeof corners[0], 2, GP_FLOAT32 };
    GpSurface *surface = NULL;
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8,
                                 .width = width,
                                 .height = ROWS,
                                 .memory = memory + offset,
                                 .pitch = pitch };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    const GpPass pass = { .color = { { surface, true, { 0.3f, 0.6f, 0.9f, 0.2f } } },
                          .draws = &draw,
                          .draw_count = 1 };
    assert_true(pitch * ROWS >= LARGE);
    memset(memory, GAP, ROWS * pitch + offset);
    run_seed_everywhere(&pass, (int)(offset + width + pitch));
    for (size_t y = 0; y + 1 < ROWS; y++)
        for (size_t x = width * TEXEL; x < width * TEXEL + 64; x++)
            assert_int_equal(memory[offset + y * pitch + x], GAP);
    gp_surface_destroy(&surface);
}

static void rows_of_large_targets_may_begin_and_end_anywhere(void **state)
{
    (void)state;
    static const size_t offsets[] = { 0, 4, 16, 64 }, pitches[] = { PITCH, PITCH + 4, PITCH + 64 };
    static const uint32_t widths[] = { 64, 192, 61, 190, 5 };
    uint8_t *memory = NULL;
    assert_int_equal(posix_memalign((void **)&memory, 64, ROWS * (PITCH + 64) + 64), 0);
    for (size_t i = 0; i < GP_COUNT(offsets) * GP_COUNT(pitches) * GP_COUNT(widths); i++)
        draw_at(memory, offsets[i % GP_COUNT(offsets)],
                widths[i / GP_COUNT(offsets) % GP_COUNT(widths)],
                pitches[i / GP_COUNT(offsets) / GP_COUNT(widths)], i % 3 == 0);
    free(memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_of_large_targets_may_begin_and_end_anywhere),
    };
    return cmocka_run_group_tests_name("fast, large", tests, NULL, NULL);
}
