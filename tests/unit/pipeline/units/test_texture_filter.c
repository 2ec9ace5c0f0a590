/* Texture filtering: weights, monotony, exact values (R46, R48). */
#include <float.h>
#include <math.h>

#include "tests/support/texture_case.h"

/* --- R46 -------------------------------------------------------------------------------------- */

static void r46_a_constant_texture_gives_that_constant_bit_for_bit(void **state)
{
    (void)state;
    Random seed = { 46 };
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 5, 3, GP_MAX_LEVELS);
        for (int round = 0; round < 60; round++) {
            float color[4], expected[4], rgba[4];
            for (int c = 0; c < 4; c++)
                color[c] = wild_value(format, &seed);
            if (round == 0 && gp_format_info(format)->is_float)
                color[0] = INFINITY, color[1] = -INFINITY, color[2] = FLT_MAX, color[3] = -0.0f;
            for (uint32_t l = 0; l < s->levels; l++)
                for (uint32_t t = 0; t < s->level[l].width * s->level[l].height; t++)
                    put(s, l, t % s->level[l].width, t / s->level[l].width, color);
            gp_texel_load(format, s->level[0].texels, expected);
            GpTexture texture = linear(s, GP_MIRROR);
            texture.sampler.mip = GP_MIP_LINEAR;
            for (int i = 0; i < 200; i++) {
                float u = (float)(random_word(&seed) >> 8) * 0x1p-22f;
                float v = (float)(random_word(&seed) >> 8) * 0x1p-22f;
                sample(&texture, u, v, (float)(random_word(&seed) >> 8) * 0x1p-22f, rgba);
                for (int c = 0; c < 4; c++)
                    assert_float_bits(rgba[c], expected[c]);
            }
        }
        gp_surface_destroy(&s);
    }
}

static void r46_every_8_bit_constant_survives_every_weight(void **state)
{
    (void)state;
    GpSurface *s = make(GP_R8, 2, 2, 1);
    GpTexture texture = linear(s, GP_WRAP);
    for (int code = 0; code < 256; code++) {
        memset(s->level[0].texels, code, 4);
        float expected = gp_float_from_unorm((uint32_t)code, 8), rgba[4];
        for (int w = 0; w < 256; w++) { /* all weights in u, 256 different ones in v */
            sample(&texture, (float)w / 512.0f, (float)((w * 77) & 255) / 512.0f, 0, rgba);
            assert_float_bits(rgba[0], expected);
        }
    }
    gp_surface_destroy(&s);
}

static void r46_the_output_lies_between_the_texels(void **state)
{
    (void)state;
    Random seed = { 461 };
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 2, 2, 1);
        GpTexture texture = linear(s, GP_CLAMP);
        for (int round = 0; round < 2000; round++) {
            float low[4], high[4], rgba[4];
            for (uint32_t t = 0; t < 4; t++) {
                float color[4];
                for (int c = 0; c < 4; c++)
                    color[c] = wild_value(format, &seed);
                put(s, 0, t & 1, t >> 1, color);
                gp_texel_load(format, texel_at(s, 0, t & 1, t >> 1), color);
                for (int c = 0; c < 4; c++) {
                    low[c] = t == 0 || color[c] < low[c] ? color[c] : low[c];
                    high[c] = t == 0 || color[c] > high[c] ? color[c] : high[c];
                }
            }
            for (int i = 0; i < 20; i++) {
                float u = 0.25f + (float)(random_word(&seed) & 255) / 512.0f;
                float v = 0.25f + (float)(random_word(&seed) & 255) / 512.0f;
                sample(&texture, u, v, 0, rgba);
                for (int c = 0; c < 4; c++)
                    assert_true(rgba[c] >= low[c] && rgba[c] <= high[c]);
            }
        }
        gp_surface_destroy(&s);
    }
}

/* Rows that rise from left to right must rise when sampled along u, at any v; and the texture on
 * its side must rise along v. */
static void assert_monotone(GpFormat format, float texels[2][4], bool along_v)
{
    GpSurface *s = make(format, along_v ? 2 : 4, along_v ? 4 : 2, 1);
    GpTexture texture = linear(s, GP_CLAMP);
    for (uint32_t row = 0; row < 2; row++)
        for (uint32_t i = 0; i < 4; i++) {
            const float color[4] = { texels[row][i], texels[row][i], texels[row][i], 1.0f };
            put(s, 0, along_v ? row : i, along_v ? i : row, color);
        }
    for (int across = 0; across <= 256; across += 37) {
        float last = -INFINITY;
        for (int step = 0; step <= 1024; step++) {
            float rgba[4], t = (float)step / 1024.0f;
            float o = 0.25f + (float)across / 512.0f;
            sample(&texture, along_v ? o : t, along_v ? t : o, 0, rgba);
            assert_true(rgba[0] >= last);
            last = rgba[0];
        }
    }
    gp_surface_destroy(&s);
}

static void r46_filtering_is_monotone_in_u_and_in_v(void **state)
{
    (void)state;
    Random seed = { 462 };
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        for (int round = 0; round < 24; round++) {
            float texels[2][4];
            for (int row = 0; row < 2; row++) {
                for (int i = 0; i < 4; i++)
                    texels[row][i] = wild_value(format, &seed);
                if (round & 1) /* neighbours one unit in the last place apart wobble first */
                    for (int i = 1; i < 4; i++)
                        texels[row][i] = nextafterf(texels[row][i - 1], INFINITY);
                for (int i = 1; i < 4; i++) /* insertion sort */
                    for (int k = i; k > 0 && texels[row][k] < texels[row][k - 1]; k--) {
                        float swap = texels[row][k];
                        texels[row][k] = texels[row][k - 1];
                        texels[row][k - 1] = swap;
                    }
            }
            assert_monotone(format, texels, false);
            assert_monotone(format, texels, true);
        }
    }
}

static void r46_a_rising_texel_never_lowers_the_result(void **state)
{
    (void)state;
    /* a + (b - a) f in binary32 fails this: b - a jumps by more than a rises. */
    GpSurface *s = make(GP_R32F, 2, 2, 1);
    GpTexture texture = linear(s, GP_CLAMP);
    bool simple_form_fails = false;
    for (int w = 1; w < 256; w += 5) {
        float f = (float)w / 256.0f, b = 16777217.0f * 1.5f, last = -INFINITY, last_simple = last;
        for (int step = 0; step < 400; step++) {
            float a = 0.25f + (float)step * 0.0078125f, rgba[4];
            for (uint32_t t = 0; t < 4; t++)
                put(s, 0, t & 1, t >> 1, (const float[4]){ t & 1 ? b : a });
            sample(&texture, 0.25f + f / 2, 0.5f, 0, rgba);
            assert_true(rgba[0] >= last);
            last = rgba[0];
            float difference = b - a, part = difference * f, simple = a + part;
            simple_form_fails |= simple < last_simple;
            last_simple = simple;
        }
    }
    assert_true(simple_form_fails);
    gp_surface_destroy(&s);
}

static void r46_unorm8_is_the_exact_bilinear_value_correctly_rounded(void **state)
{
    (void)state;
    Random seed = { 463 };
    GpSurface *s = make(GP_A8R8G8B8, 2, 2, 1);
    GpTexture texture = linear(s, GP_CLAMP);
    static const int byte_of_channel[4] = { 2, 1, 0, 3 };
    for (int round = 0; round < 100000; round++) {
        int fx = (int)(random_word(&seed) >> 24), fy = (int)(random_word(&seed) >> 24);
        float rgba[4];
        for (int b = 0; b < 16; b++)
            s->level[0].texels[b] = (uint8_t)(random_word(&seed) >> 24);
        sample(&texture, 0.25f + (float)fx / 512.0f, 0.25f + (float)fy / 512.0f, 0, rgba);
        for (int c = 0; c < 4; c++) {
            const uint8_t *t = s->level[0].texels + byte_of_channel[c];
            int64_t sum = (256 - fy) * ((256 - fx) * t[0] + fx * t[4]) +
                          fy * ((256 - fx) * t[8] + fx * t[12]);
            /* Nearest: no neighbour is nearer to sum / 16711680; 24 by 24 bits are exact. */
            double error = fabs((double)rgba[c] * 16711680.0 - (double)sum);
            float up = nextafterf(rgba[c], INFINITY), down = nextafterf(rgba[c], -INFINITY);
            assert_true(error <= fabs((double)up * 16711680.0 - (double)sum));
            assert_true(error <= fabs((double)down * 16711680.0 - (double)sum));
        }
    }
    gp_surface_destroy(&s);
}

static void r46_float_filtering_is_within_two_roundings_of_exact(void **state)
{
    (void)state;
    Random seed = { 464 };
    GpSurface *s = make(GP_R32F, 2, 2, 1);
    GpTexture texture = linear(s, GP_CLAMP);
    for (int round = 0; round < 50000; round++) {
        long double t[4], exact;
        int fx = (int)(random_word(&seed) >> 24), fy = (int)(random_word(&seed) >> 24);
        for (uint32_t i = 0; i < 4; i++) {
            float value = 1.0f + (float)(random_word(&seed) >> 8) * 0x1p-20f;
            put(s, 0, i & 1, i >> 1, (const float[4]){ value });
            t[i] = (long double)value;
        }
        exact =
            ((256 - fy) * ((256 - fx) * t[0] + fx * t[1]) + fy * ((256 - fx) * t[2] + fx * t[3])) /
            65536;
        float rgba[4];
        sample(&texture, 0.25f + (float)fx / 512.0f, 0.25f + (float)fy / 512.0f, 0, rgba);
        assert_true(fabsl((long double)rgba[0] - exact) <= exact * 0x1p-23L);
    }
    gp_surface_destroy(&s);
}

static void srgb_is_filtered_in_linear_light(void **state)
{
    (void)state;
    GpSurface *s = make(GP_A8R8G8B8_SRGB, 2, 1, 1);
    memset(texel_at(s, 0, 1, 0), 255, 4);
    GpTexture texture = linear(s, GP_CLAMP);
    float rgba[4];
    sample(&texture, 0.5f, 0.5f, 0, rgba);
    for (int c = 0; c < 4; c++)
        assert_float_bits(rgba[c], 0.5f); /* of light; encoded it would be 0.735 */
    gp_surface_destroy(&s);
}

/* --- R48 -------------------------------------------------------------------------------------- */

static void r48_texel_centres_reproduce_the_texture_exactly(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make_random(format, 4, (Random){ 48 });
        for (GpAddress mode = GP_WRAP; mode < GP_ADDRESSES; mode++) {
            GpTexture texture = linear(s, mode);
            for (uint32_t t = 0; t < 16; t++) {
                uint32_t x = t % 4, y = t / 4;
                float rgba[4], expected[4];
                gp_texel_load(format, texel_at(s, 0, x, y), expected);
                sample(&texture, ((float)x + 0.5f) / 4, ((float)y + 0.5f) / 4, 0, rgba);
                assert_memory_equal(rgba, expected, sizeof rgba);
            }
        }
        gp_surface_destroy(&s);
    }
}

static void r48_texel_corners_mix_four_texels_equally(void **state)
{
    (void)state;
    GpSurface *s = make_random(GP_A8R8G8B8, 4, (Random){ 481 });
    GpTexture texture = linear(s, GP_CLAMP);
    static const int byte_of_channel[4] = { 2, 1, 0, 3 };
    for (uint32_t t = 0; t < 16; t++) { /* pixel (x, y) of a quad from (0,0) to (4,4) */
        uint32_t x = t % 4, y = t / 4;
        uint32_t left = x ? x - 1 : 0, above = y ? y - 1 : 0; /* clamped */
        float uvr[3] = { (float)x / 4, (float)y / 4, 0 }, rgba[4];
        GpSampleReport report;
        gp_texture_sample(&texture, uvr, 0, rgba, &report);
        for (int c = 0; c < 4; c++) {
            int b = byte_of_channel[c];
            int sum = texel_at(s, 0, left, above)[b] + texel_at(s, 0, x, above)[b] +
                      texel_at(s, 0, left, y)[b] + texel_at(s, 0, x, y)[b];
            assert_float_bits(rgba[c], (float)sum / 1020.0f);
        }
        assert_int_equal(report.count, 4);
        for (int i = 0; i < 4; i++)
            assert_true(report.texel[i].weight == 0.25f);
    }
    gp_surface_destroy(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r46_a_constant_texture_gives_that_constant_bit_for_bit),
        cmocka_unit_test(r46_every_8_bit_constant_survives_every_weight),
        cmocka_unit_test(r46_the_output_lies_between_the_texels),
        cmocka_unit_test(r46_filtering_is_monotone_in_u_and_in_v),
        cmocka_unit_test(r46_a_rising_texel_never_lowers_the_result),
        cmocka_unit_test(r46_unorm8_is_the_exact_bilinear_value_correctly_rounded),
        cmocka_unit_test(r46_float_filtering_is_within_two_roundings_of_exact),
        cmocka_unit_test(srgb_is_filtered_in_linear_light),
        cmocka_unit_test(r48_texel_centres_reproduce_the_texture_exactly),
        cmocka_unit_test(r48_texel_corners_mix_four_texels_equally),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
