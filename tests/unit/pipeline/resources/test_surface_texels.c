/* What is done with all texels of a surface: clears, mip levels, hashes. */
#include <xxhash.h>

#include "tests/support/surfaces/texels.h"

/* --- clears ----------------------------------------------------------------------------------- */

static void clear_color_fills_level_0_and_no_other(void **state)
{
    (void)state;
    static const float color[4] = { 0.25f, 0.5f, 0.75f, 1.0f };
    for (GpFormat format = GP_A8R8G8B8; format < GP_D16; format++) {
        GpSurface *s = make(format, 5, 3, 2);
        uint8_t expected[16];
        size_t bytes = gp_format_info(format)->bytes;
        gp_texel_store(format, expected, color, 0);
        gp_surface_clear_color(s, color);
        for (uint32_t y = 0; y < 3; y++)
            for (uint32_t x = 0; x < 5; x++)
                assert_memory_equal(texel_at(s, 0, x, y), expected, bytes);
        for (size_t b = 0; b < s->level[1].pitch * s->level[1].height; b++)
            assert_int_equal(s->level[1].texels[b], 0);
        gp_surface_destroy(&s);
    }
}

static void clears_of_rectangles_are_cut_to_the_surface(void **state)
{
    (void)state;
    static const GpRect rects[] = {
        { 1, 1, 3, 2 }, { -4, -4, 2, 99 }, { 4, 2, 9, 9 },
        { 3, 2, 3, 9 }, { 4, 1, 2, 3 },    { 9, 9, 12, 12 },
    };
    for (size_t i = 0; i < GP_COUNT(rects); i++) {
        GpSurface *color = make(GP_R32F, 5, 3, 1), *depth = make(GP_D16, 5, 3, 1);
        gp_surface_clear_color_rect(color, rects[i], (const float[4]){ 1 });
        gp_surface_clear_depth_rect(depth, rects[i], 1, 0, true, false);
        for (int t = 0; t < 15; t++) {
            const int x = t % 5, y = t / 5;
            const bool in =
                x >= rects[i].x0 && x < rects[i].x1 && y >= rects[i].y0 && y < rects[i].y1;
            float rgba[4];
            load(color, 0, (uint32_t)x, (uint32_t)y, rgba);
            assert_true(rgba[0] == (in ? 1 : 0));
            load(depth, 0, (uint32_t)x, (uint32_t)y, rgba);
            assert_true(rgba[0] == (in ? 1 : 0));
        }
        gp_surface_destroy(&color);
        gp_surface_destroy(&depth);
    }
}

static void clear_depth_and_stencil_are_independent(void **state)
{
    (void)state;
    GpSurface *s = make(GP_D24S8, 3, 2, 1);
    const uint32_t half = 8388608; /* 0.5 * (2^24 - 1) + 0.5 */
    static const struct {
        float depth;
        uint8_t stencil;
        bool clear_depth, clear_stencil;
        uint32_t expected_code;
        uint8_t expected_stencil;
    } steps[] = {
        { 1.0f, 7, true, true, 0xffffff, 7 },  { 0.5f, 9, true, false, half, 7 },
        { 0.25f, 9, false, true, half, 9 },    { 0.25f, 1, false, false, half, 9 },
        { 2.0f, 1, true, false, 0xffffff, 9 }, { -1.0f, 1, true, false, 0, 9 },
    };
    for (size_t i = 0; i < GP_COUNT(steps); i++) {
        gp_surface_clear_depth(s, steps[i].depth, steps[i].stencil, steps[i].clear_depth,
                               steps[i].clear_stencil);
        for (uint32_t t = 0; t < 6; t++) {
            uint32_t code;
            uint8_t stencil;
            gp_depth_load(GP_D24S8, texel_at(s, 0, t % 3, t / 3), &code, &stencil);
            assert_int_equal(code, steps[i].expected_code);
            assert_int_equal(stencil, steps[i].expected_stencil);
        }
    }
    gp_surface_destroy(&s);
}

static void clear_depth_reaches_every_texel_of_every_depth_format(void **state)
{
    (void)state;
    for (GpFormat format = GP_D16; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 5, 3, 1);
        gp_surface_clear_depth(s, 0.75f, 1, true, true);
        for (uint32_t t = 0; t < 15; t++) {
            uint32_t code;
            uint8_t stencil;
            gp_depth_load(format, texel_at(s, 0, t % 5, t / 5), &code, &stencil);
            assert_int_equal(code, gp_depth_code(format, 0.75f));
            assert_int_equal(stencil, format == GP_D24S8);
        }
        gp_surface_destroy(&s);
    }
}

/* --- mip levels ------------------------------------------------------------------------------- */

static void mips_of_a_constant_are_that_constant(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_D16; format++) {
        GpSurface *s = make(format, 7, 4, GP_MAX_LEVELS);
        size_t bytes = gp_format_info(format)->bytes;
        for (int code = 0; code < 256; code++) {
            float v = (float)code / 255.0f;
            const float color[4] = { v, 1.0f - v, v * v, v };
            gp_surface_clear_color(s, color);
            gp_surface_build_mips(s);
            for (uint32_t i = 1; i < s->levels; i++)
                for (size_t b = 0; b < s->level[i].pitch * s->level[i].height; b += bytes)
                    assert_memory_equal(s->level[i].texels + b, s->level[0].texels, bytes);
        }
        gp_surface_destroy(&s);
    }
    GpSurface *s = make(GP_R32F, 2, 2, 2); /* the largest float: its sum is none */
    const float largest[4] = { 3.40282347e38f };
    gp_surface_clear_color(s, largest);
    gp_surface_build_mips(s);
    assert_memory_equal(s->level[1].texels, s->level[0].texels, 4);
    gp_surface_destroy(&s);
}

static void mips_are_box_means_within_half_a_code(void **state)
{
    (void)state;
    GpSurface *s = make(GP_R8, 64, 32, GP_MAX_LEVELS);
    for (uint32_t i = 0; i < 64 * 32; i++)
        s->level[0].texels[i] = (uint8_t)((i * 2654435761u) >> 24);
    gp_surface_build_mips(s);
    int rounded_up = 0, rounded_down = 0;
    for (uint32_t l = 1; l < s->levels; l++) {
        const GpLevel *fine = &s->level[l - 1], *coarse = &s->level[l];
        for (uint32_t y = 0; y < coarse->height; y++) {
            for (uint32_t x = 0; x < coarse->width; x++) {
                uint32_t x1 = fine->width > 1 ? 2 * x + 1 : 0;
                uint32_t y1 = fine->height > 1 ? 2 * y + 1 : 0;
                int sum = *texel_at(s, l - 1, 2 * x, 2 * y) + *texel_at(s, l - 1, x1, 2 * y) +
                          *texel_at(s, l - 1, 2 * x, y1) + *texel_at(s, l - 1, x1, y1);
                int error = 4 * *texel_at(s, l, x, y) - sum;
                assert_true(error >= -2 && error <= 2);
                rounded_up += error > 0;
                rounded_down += error < 0;
            }
        }
    }
    assert_true(rounded_up > 0 && rounded_down > 0);
    gp_surface_destroy(&s);
}

static void mips_of_floats_are_exact_means(void **state)
{
    (void)state;
    GpSurface *s = make(GP_A32B32G32R32F, 5, 3, GP_MAX_LEVELS); /* column 4 and row 2 drop out */
    for (uint32_t t = 0; t < 15; t++) {
        float v = (float)t, rgba[4] = { v, -v, v * 0.5f, 1.0f };
        gp_texel_store(s->format, texel_at(s, 0, t % 5, t / 5), rgba, 0);
    }
    gp_surface_build_mips(s);
    static const float means[3] = { (0 + 1 + 5 + 6) / 4.0f, (2 + 3 + 7 + 8) / 4.0f, 4.0f };
    for (uint32_t i = 0; i < 3; i++) { /* two texels of level 1, then the one of level 2 */
        float rgba[4];
        load(s, i < 2 ? 1 : 2, i < 2 ? i : 0, 0, rgba);
        assert_true(rgba[0] == means[i] && rgba[1] == -means[i]);
        assert_true(rgba[2] == 0.5f * means[i] && rgba[3] == 1.0f);
    }
    gp_surface_destroy(&s);
}

static void r26_mips_of_srgb_are_means_of_light(void **state)
{
    (void)state;
    GpSurface *s = make(GP_A8R8G8B8_SRGB, 2, 2, 2);
    for (uint32_t t = 0; t < 2; t++)
        memset(texel_at(s, 0, t, t), 255, 4); /* a chequer of black and white */
    gp_surface_build_mips(s);
    /* Half the light is sRGB 187.5 (0.7354); the mean of the codes would be 128, as alpha's is. */
    assert_memory_equal(s->level[1].texels, "\xbc\xbc\xbc\x80", 4);
    gp_surface_destroy(&s);
}

/* --- hash ------------------------------------------------------------------------------------- */

static void hash_is_xxh3_of_the_raw_bytes_of_level_0(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 9, 5, 2);
        uint8_t bytes[9 * 5 * 16];
        size_t size = (size_t)9 * 5 * gp_format_info(format)->bytes;
        for (size_t i = 0; i < size; i++)
            bytes[i] = (uint8_t)(i * 31 + 7);
        memcpy(s->level[0].texels, bytes, size);
        uint64_t hash = gp_surface_hash(s);
        assert_true(hash == XXH3_64bits(bytes, size));
        s->level[1].texels[0] ^= 1;
        assert_true(gp_surface_hash(s) == hash);
        s->level[0].texels[size - 1] ^= 1;
        assert_false(gp_surface_hash(s) == hash);
        gp_surface_destroy(&s);
    }
}

static void hash_does_not_see_what_lies_between_rows(void **state)
{
    (void)state;
    uint8_t packed[31 * 40], apart[33 * 40];
    memset(apart, 0xee, sizeof apart);
    for (size_t i = 0; i < sizeof packed; i++)
        apart[i / 31 * 33 + i % 31] = packed[i] = (uint8_t)(i * 2654435761u >> 13);
    GpSurfaceDesc desc = {
        .format = GP_R8, .width = 31, .height = 40, .memory = apart, .pitch = 33
    };
    GpSurface *s = NULL;
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    assert_true(gp_surface_hash(s) == XXH3_64bits(packed, sizeof packed));
    apart[31] ^= 1;
    assert_true(gp_surface_hash(s) == XXH3_64bits(packed, sizeof packed));
    gp_surface_destroy(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clear_color_fills_level_0_and_no_other),
        cmocka_unit_test(clears_of_rectangles_are_cut_to_the_surface),
        cmocka_unit_test(clear_depth_and_stencil_are_independent),
        cmocka_unit_test(clear_depth_reaches_every_texel_of_every_depth_format),
        cmocka_unit_test(mips_of_a_constant_are_that_constant),
        cmocka_unit_test(mips_are_box_means_within_half_a_code),
        cmocka_unit_test(mips_of_floats_are_exact_means),
        cmocka_unit_test(r26_mips_of_srgb_are_means_of_light),
        cmocka_unit_test(hash_is_xxh3_of_the_raw_bytes_of_level_0),
        cmocka_unit_test(hash_does_not_see_what_lies_between_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
