/* Output: living pixels alone are read and written, at their own place, rounded to the format. */
#include "pipeline/units/output.h"
#include "tests/support/unit.h"

enum { SIDE = 4, BYTE = 0xa5 };

static GpSurface *surface_of(GpFormat format)
{
    GpSurface *surface = NULL;
    assert_int_equal(
        gp_surface_create(&(GpSurfaceDesc){ .format = format, .width = SIDE, .height = SIDE },
                          &surface, NULL),
        GP_OK);
    memset(surface->level[0].texels, BYTE, surface->level[0].pitch * SIDE);
    return surface;
}

static const uint8_t *texel_at(const GpSurface *surface, int x, int y)
{
    return gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes, (uint32_t)x,
                            (uint32_t)y);
}

static const GpFormat formats[] = { GP_A8R8G8B8,      GP_R8,   GP_G16R16F,
                                    GP_A16B16G16R16F, GP_R32F, GP_A32B32G32R32F };

static GpQuad quad_of_colors(unsigned mask)
{
    GpQuad quad = { .x = 2, .y = 0, .mask = mask };
    for (int c = 0; c < 4; c++)
        for (int p = 0; p < 4; p++)
            quad.color[1][c][p] = 0.1f * (float)(1 + c) + 0.13f * (float)p;
    return quad;
}

/* For all masks: what lies outside the quad, and its dead pixels, keep their bits. */
static void r24_r27_living_pixels_are_stored_as_the_format_rounds(void **state)
{
    (void)state;
    for (size_t f = 0; f < GP_COUNT(formats); f++)
        for (unsigned mask = 0; mask < 16; mask++) {
            GpSurface *surface = surface_of(formats[f]);
            const size_t bytes = gp_format_info(formats[f])->bytes;
            const GpQuad quad = quad_of_colors(mask);
            gp_output_store(surface, 1, 0, &quad);
            for (int y = 0; y < SIDE; y++)
                for (int x = 0; x < SIDE; x++) {
                    uint8_t expected[16];
                    memset(expected, BYTE, sizeof expected);
                    const int p = x - 2 + 2 * y;
                    if (x >= 2 && y < 2 && mask >> p & 1) {
                        float rgba[4];
                        for (int c = 0; c < 4; c++)
                            rgba[c] = quad.color[1][c][p];
                        gp_texel_store(formats[f], expected, rgba, 0);
                    }
                    assert_memory_equal(texel_at(surface, x, y), expected, bytes);
                }
            gp_surface_destroy(&surface);
        }
}

static void r37_channels_outside_the_write_mask_keep_their_bits(void **state)
{
    (void)state;
    for (unsigned keep = 0; keep < 16; keep++) {
        GpSurface *surface = surface_of(GP_A8R8G8B8);
        GpQuad quad = { .mask = 1 };
        for (int c = 0; c < 4; c++)
            quad.color[0][c][0] = 1;
        gp_output_store(surface, 0, keep, &quad);
        const uint8_t *texel = texel_at(surface, 0, 0); /* bytes b g r a */
        assert_int_equal(texel[2], keep & 1 ? BYTE : 255);
        assert_int_equal(texel[1], keep & 2 ? BYTE : 255);
        assert_int_equal(texel[0], keep & 4 ? BYTE : 255);
        assert_int_equal(texel[3], keep & 8 ? BYTE : 255);
        gp_surface_destroy(&surface);
    }
}

/* Of pixels that replace, and no others, whatever their write mask leaves. */
static void clearing_goes_through_the_write_mask(void **state)
{
    (void)state;
    for (size_t f = 0; f < GP_COUNT(formats); f++)
        for (unsigned keep = 0; keep < 16; keep++) {
            GpSurface *surface = surface_of(formats[f]);
            const size_t bytes = gp_format_info(formats[f])->bytes;
            const GpQuad quad = { .x = 2, .y = 2, .mask = 15, .replaced = 5 };
            gp_output_clear(surface, keep, &quad);
            for (int i = 0; i < SIDE * SIDE; i++) {
                const int x = i % SIDE, y = i / SIDE;
                static const float nothing[4] = { 0 };
                uint8_t expected[16];
                memset(expected, BYTE, sizeof expected);
                if (x == 2 && y >= 2)
                    gp_texel_store(formats[f], expected, nothing, keep);
                assert_memory_equal(texel_at(surface, x, y), expected, bytes);
            }
            gp_surface_destroy(&surface);
        }
}

/* Missing channels read as 1; dead pixels are not read. */
static void what_is_stored_is_loaded(void **state)
{
    (void)state;
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        GpSurface *surface = surface_of(formats[f]);
        GpQuad quad = quad_of_colors(15);
        gp_output_store(surface, 1, 0, &quad);
        for (int p = 0; p < 4; p++)
            quad.destination[3][0][p] = -7;
        quad.mask = 13;
        gp_output_load(surface, 3, &quad);
        for (int p = 0; p < 4; p++) {
            float rgba[4];
            gp_texel_load(formats[f], texel_at(surface, 2 + p % 2, p / 2), rgba);
            for (int c = 0; p != 1 && c < 4; c++) {
                assert_true(quad.destination[3][c][p] == rgba[c]);
                assert_true(c < gp_format_info(formats[f])->channels || rgba[c] == 1);
            }
        }
        assert_true(quad.destination[3][0][1] == -7);
        gp_surface_destroy(&surface);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r24_r27_living_pixels_are_stored_as_the_format_rounds),
        cmocka_unit_test(r37_channels_outside_the_write_mask_keep_their_bits),
        cmocka_unit_test(clearing_goes_through_the_write_mask),
        cmocka_unit_test(what_is_stored_is_loaded),
    };
    return cmocka_run_group_tests_name("output", tests, NULL, NULL);
}
