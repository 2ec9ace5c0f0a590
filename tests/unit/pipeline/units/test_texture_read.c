/* Texture reads of whole packets: slots that are not bound, and texels in place. */
#include "pipeline/resources/surface.h"
#include "pipeline/units/texture_read.h"
#include "tests/support/unit.h"

enum { LANES = 4, WIDTH = 3, HEIGHT = 2 };

/* Helper pixels of quads lie past the edges of odd sides; memory goes on there. */
static void texels_in_place_are_0_past_the_surface(void **state)
{
    (void)state;
    _Alignas(64) float memory[WIDTH * (HEIGHT + 2)];
    for (int i = 0; i < WIDTH * (HEIGHT + 2); i++)
        memory[i] = 1 + (float)i;
    GpSurface *surface = NULL;
    const GpSurfaceDesc desc = {
        .format = GP_R32F, .width = WIDTH, .height = HEIGHT, .memory = memory
    };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    const GpTexture texture = { .surface = surface };
    for (int32_t y = 0; y <= HEIGHT; y++) {
        const float row = (float)y + 0.5f;
        const float pixel[2 * LANES] = { 0.5f, 1.5f, 2.5f, 3.5f, row, row, row, row };
        float texel[4 * LANES];
        gp_read_local_plain(&(GpShaderCall){ .pixel = pixel, .textures = &texture }, 0, 0, LANES,
                            texel);
        for (int32_t x = 0; x < LANES; x++) {
            const bool inside = x < WIDTH && y < HEIGHT;
            assert_true(texel[x] == (inside ? memory[y * WIDTH + x] : 0.0f));
        }
    }
    gp_surface_destroy(&surface);
}

static void a_slot_that_is_not_bound_gives_opaque_black(void **state)
{
    (void)state;
    const GpTexture texture = { .surface = NULL };
    const float coord[4 * LANES] = { 0.5f };
    float texel[4 * LANES];
    const GpTextureRead read = { .lanes = LANES, .coord = coord, .texel = texel };
    gp_texture_read(&texture, &read, LANES, NULL);
    for (int i = 0; i < 4 * LANES; i++)
        assert_true(texel[i] == (i / LANES == 3 ? 1.0f : 0.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texels_in_place_are_0_past_the_surface),
        cmocka_unit_test(a_slot_that_is_not_bound_gives_opaque_black),
    };
    return cmocka_run_group_tests_name("texture reads", tests, NULL, NULL);
}
