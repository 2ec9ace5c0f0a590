/* Texture filtering, depth comparison, borders and sample reports (R46, R48, R49). */
#include <float.h>
#include <math.h>

#include "pipeline/units/texture.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#define assert_float_bits(a, b) assert_int_equal(gp_float_bits(a), gp_float_bits(b))

static GpSurface *make(GpFormat format, uint32_t width, uint32_t height, uint32_t levels)
{
    GpSurface *surface = NULL;
    GpSurfaceDesc desc = { .format = format, .width = width, .height = height, .levels = levels };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    return surface;
}

static uint8_t *texel_at(const GpSurface *s, uint32_t level, uint32_t x, uint32_t y)
{
    return gp_surface_texel(&s->level[level], gp_format_info(s->format)->bytes, x, y);
}

static void put(const GpSurface *s, uint32_t level, uint32_t x, uint32_t y, const float rgba[4])
{
    if (gp_format_info(s->format)->is_depth)
        gp_depth_store(s->format, texel_at(s, level, x, y), gp_depth_code(s->format, rgba[0]), 99);
    else
        gp_texel_store(s->format, texel_at(s, level, x, y), rgba, 0);
}

static GpTexture linear(const GpSurface *surface, GpAddress address)
{
    return (GpTexture){ .surface = surface,
                        .sampler = { .min = GP_LINEAR,
                                     .mag = GP_LINEAR,
                                     .address_u = address,
                                     .address_v = address } };
}

static void sample(const GpTexture *texture, float u, float v, float lod, float rgba[4])
{
    const float uvr[3] = { u, v, 0 };
    gp_texture_sample(texture, uvr, lod, rgba, NULL);
}

/* Texel values of every size a format can hold, from tiny to huge, and of both signs. */
static float wild_value(GpFormat format, Random *seed)
{
    uint32_t bits = random_word(seed);
    if (!gp_format_info(format)->is_float)
        return (float)(bits >> 8) * 0x1p-24f;
    if (gp_format_info(format)->bytes / gp_format_info(format)->channels == 2)
        return gp_float_from_half((uint16_t)(bits % 0x7c00u | (bits & 0x80000000u) >> 16));
    return gp_bits_float(bits % 0x7f800000u | (random_word(seed) & 0x80000000u));
}

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

static GpSurface *make_random(GpFormat format, uint32_t size, Random seed)
{
    GpSurface *s = make(format, size, size, 1);
    for (uint32_t t = 0; t < size * size; t++) {
        float color[4];
        for (int c = 0; c < 4; c++)
            color[c] = wild_value(format, &seed);
        put(s, 0, t % size, t / size, color);
    }
    return s;
}

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

/* --- R49 -------------------------------------------------------------------------------------- */

static float compare(const GpTexture *texture, float u, float v, float r)
{
    const float uvr[3] = { u, v, r };
    float rgba[4];
    gp_texture_sample(texture, uvr, 0, rgba, NULL);
    for (int c = 1; c < 4; c++)
        assert_float_bits(rgba[c], rgba[0]);
    return rgba[0];
}

static void r49_sixteen_patterns_by_all_weights(void **state)
{
    (void)state;
    GpSurface *s = make(GP_D16, 2, 2, 1);
    GpTexture texture = linear(s, GP_CLAMP);
    texture.sampler.compare = true;
    uint32_t wrong = 0;
    for (unsigned pattern = 0; pattern < 16; pattern++) {
        for (uint32_t t = 0; t < 4; t++)
            put(s, 0, t & 1, t >> 1, (const float[4]){ pattern >> t & 1 ? 0.75f : 0.25f });
        for (unsigned fy = 0; fy < 256; fy++) {
            for (unsigned fx = 0; fx < 256; fx++) {
                const unsigned weights[4] = { (256 - fx) * (256 - fy), fx * (256 - fy),
                                              (256 - fx) * fy, fx * fy };
                unsigned sum = 0;
                for (int t = 0; t < 4; t++)
                    sum += pattern >> t & 1 ? weights[t] : 0;
                const float uvr[3] = { 0.25f + (float)fx / 512, 0.25f + (float)fy / 512, 0.5f };
                float rgba[4];
                gp_texture_sample(&texture, uvr, 0, rgba, NULL);
                wrong += rgba[0] * 65536.0f != (float)sum;
            }
        }
    }
    assert_int_equal(wrong, 0);
    gp_surface_destroy(&s);
}

static void r49_point_gives_zero_or_one(void **state)
{
    (void)state;
    for (GpFormat format = GP_D16; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 2, 1, 1);
        put(s, 0, 0, 0, (const float[4]){ 0.25f });
        put(s, 0, 1, 0, (const float[4]){ 0.75f });
        GpTexture texture = { .surface = s, .sampler = { .compare = true } };
        for (int step = 0; step <= 64; step++) {
            float u = (float)step / 65.0f, expected = u * 2.0f < 1.0f ? 0.0f : 1.0f;
            assert_float_bits(compare(&texture, u, 0.5f, 0.5f), expected);
        }
        gp_surface_destroy(&s);
    }
}

static void r49_both_sides_are_compared_as_stored_codes(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_D16, GP_D24S8 };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        GpSurface *s = make(formats[f], 1, 1, 1);
        GpTexture texture = { .surface = s, .sampler = { .compare = true } };
        Random seed = { 49 };
        uint32_t lit_against_the_float = 0;
        for (int i = 0; i < 20000; i++) {
            float depth = (float)(random_word(&seed) >> 8) * 0x1p-26f; /* finer than D24 */
            uint32_t code = gp_depth_code(formats[f], depth);
            float stored = gp_depth_from_code(formats[f], code);
            put(s, 0, 0, 0, (const float[4]){ depth });
            /* A surface passes against its own depth, even where storing made that smaller. */
            assert_float_bits(compare(&texture, 0.5f, 0.5f, depth), 1.0f);
            lit_against_the_float += depth > stored;
            if (code < (1u << gp_format_info(formats[f])->depth_bits) - 1)
                assert_float_bits(
                    compare(&texture, 0.5f, 0.5f, gp_depth_from_code(formats[f], code + 1)), 0.0f);
        }
        assert_true(lit_against_the_float > 0); /* or the test would prove nothing */
        gp_surface_destroy(&s);
    }
}

static void r49_d32f_is_compared_as_floats(void **state)
{
    (void)state;
    GpSurface *s = make(GP_D32F, 1, 1, 1);
    GpTexture texture = { .surface = s, .sampler = { .compare = true } };
    Random seed = { 491 };
    for (int i = 0; i < 20000; i++) {
        float depth = gp_bits_float(random_word(&seed) % 0x3f800000u);
        put(s, 0, 0, 0, (const float[4]){ depth });
        assert_float_bits(compare(&texture, 0.5f, 0.5f, depth), 1.0f);
        assert_float_bits(compare(&texture, 0.5f, 0.5f, nextafterf(depth, 2.0f)), 0.0f);
    }
    /* Whatever bits someone put there: negative depths order as floats, NaN is never passed. */
    gp_depth_store(GP_D32F, texel_at(s, 0, 0, 0), gp_float_bits(-0.5f), 0);
    assert_float_bits(compare(&texture, 0.5f, 0.5f, 0.0f), 0.0f);
    gp_depth_store(GP_D32F, texel_at(s, 0, 0, 0), gp_float_bits(-0.0f), 0);
    assert_float_bits(compare(&texture, 0.5f, 0.5f, 0.0f), 1.0f);
    gp_depth_store(GP_D32F, texel_at(s, 0, 0, 0), 0x7fc00000u, 0);
    assert_float_bits(compare(&texture, 0.5f, 0.5f, 0.0f), 0.0f);
    gp_surface_destroy(&s);
}

static void r49_the_reference_is_clamped(void **state)
{
    (void)state;
    for (GpFormat format = GP_D16; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 1, 1, 1);
        GpTexture texture = { .surface = s, .sampler = { .compare = true } };
        put(s, 0, 0, 0, (const float[4]){ 1.0f });
        assert_float_bits(compare(&texture, 0.5f, 0.5f, 7.0f), 1.0f);
        assert_float_bits(compare(&texture, 0.5f, 0.5f, INFINITY), 1.0f);
        put(s, 0, 0, 0, (const float[4]){ 0.0f });
        assert_float_bits(compare(&texture, 0.5f, 0.5f, -7.0f), 1.0f);
        assert_float_bits(compare(&texture, 0.5f, 0.5f, 0.5f), 0.0f);
        /* NaN is code 0 where depth is stored as a code, and unordered where it is a float. */
        assert_float_bits(compare(&texture, 0.5f, 0.5f, NAN), format == GP_D32F ? 0.0f : 1.0f);
        gp_surface_destroy(&s);
    }
}

static void r49_the_border_is_a_depth(void **state)
{
    (void)state;
    for (GpFormat format = GP_D16; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 2, 2, 1); /* depth 0: nothing passes inside */
        GpTexture texture = linear(s, GP_BORDER);
        texture.sampler.compare = true;
        texture.sampler.border[0] = 1.0f;
        assert_float_bits(compare(&texture, -1.0f, 0.5f, 0.5f), 1.0f);
        assert_float_bits(compare(&texture, 0.0f, 0.5f, 0.5f), 0.5f);
        assert_float_bits(compare(&texture, 0.5f, 0.5f, 0.5f), 0.0f);
        texture.sampler.border[0] = 0.25f;
        assert_float_bits(compare(&texture, -1.0f, 0.5f, 0.5f), 0.0f);
        assert_float_bits(compare(&texture, -1.0f, 0.5f, 0.25f), 1.0f);
        gp_surface_destroy(&s);
    }
}

/* --- borders and missing channels ------------------------------------------------------------- */

static void r41_the_border_wins_if_any_axis_is_out(void **state)
{
    (void)state;
    GpSurface *s = make(GP_A8R8G8B8, 4, 4, 1); /* black inside */
    for (GpAddress mode = GP_WRAP; mode < GP_ADDRESSES; mode++) {
        for (int swap = 0; swap < 2; swap++) {
            GpTexture texture = { .surface = s, .sampler = { .border = { 1, 1, 1, 1 } } };
            texture.sampler.address_u = swap ? mode : GP_BORDER;
            texture.sampler.address_v = swap ? GP_BORDER : mode;
            for (int out_u = 0; out_u < 2; out_u++)
                for (int out_v = 0; out_v < 2; out_v++) {
                    bool out = swap ? out_v : out_u; /* on the axis that has the border */
                    bool other = mode == GP_BORDER && (swap ? out_u : out_v);
                    float rgba[4];
                    sample(&texture, out_u ? 1.5f : 0.5f, out_v ? -0.5f : 0.5f, 0, rgba);
                    assert_float_bits(rgba[0], out || other ? 1.0f : 0.0f);
                }
        }
    }
    gp_surface_destroy(&s);
}

static void the_border_is_a_texel_of_the_format(void **state)
{
    (void)state;
    static const float border[4] = { 0.3f, 1.7f, -0.2f, 0.6f };
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        GpSurface *s = make(format, 2, 2, 1);
        GpTexture texture = linear(s, GP_BORDER);
        memcpy(texture.sampler.border, border, sizeof border);
        put(s, 0, 0, 0, border);
        float expected[4], rgba[4];
        gp_texel_load(format, texel_at(s, 0, 0, 0), expected);
        sample(&texture, 3.0f, 3.0f, 0, rgba);
        assert_memory_equal(rgba, expected, sizeof rgba);
        gp_surface_destroy(&s);
    }
}

static void missing_channels_sample_as_one_also_at_the_border(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        const GpFormatInfo *info = gp_format_info(format);
        int present = info->is_depth ? 1 : info->channels;
        GpSurface *s = make(format, 2, 2, 2);
        GpTexture texture = linear(s, GP_BORDER);
        texture.sampler.mip = GP_MIP_LINEAR;
        for (float u = -0.5f; u < 1.5f; u += 0.13f) {
            float rgba[4];
            sample(&texture, u, 0.3f, 0.4f, rgba);
            for (int c = 0; c < 4; c++)
                assert_float_bits(rgba[c], c < present ? 0.0f : 1.0f);
        }
        gp_surface_destroy(&s);
    }
}

static void an_unbound_texture_is_opaque_black(void **state)
{
    (void)state;
    GpTexture texture = { .surface = NULL };
    GpSampleReport report;
    memset(&report, 0xff, sizeof report);
    const float uvr[3] = { 0.5f, 0.5f, 0.5f };
    float rgba[4];
    gp_texture_sample(&texture, uvr, 3.0f, rgba, &report);
    assert_true(rgba[0] == 0 && rgba[1] == 0 && rgba[2] == 0 && rgba[3] == 1);
    assert_int_equal(report.count, 0);
}

/* --- levels and filters ----------------------------------------------------------------------- */

static GpSurface *make_numbered_levels(GpFormat format)
{
    GpSurface *s = make(format, 8, 8, GP_MAX_LEVELS);
    for (uint32_t l = 0; l < s->levels; l++)
        for (uint32_t t = 0; t < s->level[l].width * s->level[l].height; t++)
            put(s, l, t % s->level[l].width, t / s->level[l].width, (const float[4]){ (float)l });
    return s;
}

static void r43_mip_filters_blend_levels_by_the_8_bit_fraction(void **state)
{
    (void)state;
    GpSurface *s = make_numbered_levels(GP_R32F);
    GpTexture texture = linear(s, GP_CLAMP);
    for (int step = 0; step <= 5 * 256; step++) {
        float lod = (float)step / 256.0f, rgba[4];
        texture.sampler.mip = GP_MIP_LINEAR;
        sample(&texture, 0.3f, 0.6f, lod, rgba);
        assert_float_bits(rgba[0], lod < 3.0f ? lod : 3.0f);
        texture.sampler.mip = GP_MIP_POINT;
        sample(&texture, 0.3f, 0.6f, lod, rgba);
        assert_float_bits(rgba[0], lod < 2.5f ? floorf(lod + 0.5f) : 3.0f);
        texture.sampler.mip = GP_MIP_NONE;
        sample(&texture, 0.3f, 0.6f, lod, rgba);
        assert_float_bits(rgba[0], 0.0f);
    }
    gp_surface_destroy(&s);
}

static void r44_magnification_and_minification_use_their_filters(void **state)
{
    (void)state;
    GpSurface *s = make(GP_R32F, 2, 1, 1);
    put(s, 0, 1, 0, (const float[4]){ 1.0f });
    GpTexture texture = { .surface = s, .sampler = { .min = GP_POINT, .mag = GP_LINEAR } };
    texture.sampler.address_u = GP_CLAMP;
    float rgba[4];
    sample(&texture, 0.375f, 0.5f, 0.0f, rgba);
    assert_float_bits(rgba[0], 0.25f);
    sample(&texture, 0.375f, 0.5f, 0.1f, rgba);
    assert_float_bits(rgba[0], 0.0f);
    texture.sampler.min = GP_LINEAR;
    texture.sampler.mag = GP_POINT;
    sample(&texture, 0.375f, 0.5f, 0.0f, rgba);
    assert_float_bits(rgba[0], 0.0f);
    sample(&texture, 0.375f, 0.5f, 0.1f, rgba);
    assert_float_bits(rgba[0], 0.25f);
    gp_surface_destroy(&s);
}

/* --- odd values ------------------------------------------------------------------------------- */

static void nan_texels_propagate_but_only_with_a_weight(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_G16R16F, GP_A16B16G16R16F, GP_R32F, GP_A32B32G32R32F };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        GpSurface *s = make(formats[f], 4, 4, 1);
        GpTexture texture = linear(s, GP_CLAMP);
        float rgba[4];
        put(s, 0, 1, 1, (const float[4]){ NAN, 0, 0, 0 });
        sample(&texture, 0.5f, 0.5f, 0, rgba);
        assert_true(isnan(rgba[0]));
        sample(&texture, 0.625f - 1.0f / 1024, 0.5f, 0, rgba); /* weight 1/256 * 1/2 */
        assert_true(isnan(rgba[0]));
        sample(&texture, 0.625f, 0.375f, 0, rgba); /* the centre of its neighbour: weight 0 */
        assert_float_bits(rgba[0], 0.0f);
        sample(&texture, 0.375f, 0.625f, 0, rgba);
        assert_float_bits(rgba[0], 0.0f);
        gp_surface_destroy(&s);
    }
}

/* Whatever the coordinates, no read leaves the surface: sanitizers watch the heap, and the report
 * names every texel. */
static void odd_coordinates_and_lods_stay_inside(void **state)
{
    (void)state;
    static const float odd[] = { NAN,       INFINITY, -INFINITY, FLT_MAX,  -FLT_MAX,
                                 0x1p-149f, -0.0f,    -1e-9f,    1.0f,     2.0f,
                                 -1.0f,     0x1p24f,  -0x1p24f,  0.999999f };
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_R32F, GP_D24S8 };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        GpSurface *s = make(formats[f], 5, 3, GP_MAX_LEVELS);
        for (GpAddress mode = GP_WRAP; mode < GP_ADDRESSES; mode++)
            for (size_t i = 0; i < GP_COUNT(odd) * GP_COUNT(odd) * GP_COUNT(odd); i++) {
                size_t n = GP_COUNT(odd);
                float uvr[3] = { odd[i % n], odd[i / n % n], odd[i % n] }, rgba[4];
                GpTexture texture = linear(s, mode);
                texture.sampler.mip = GP_MIP_LINEAR;
                texture.sampler.compare = formats[f] == GP_D24S8 && i % 2;
                GpSampleReport report;
                gp_texture_sample(&texture, uvr, odd[i / n / n], rgba, &report);
                assert_true(report.count >= 1 && report.count <= 8);
                for (int k = 0; k < report.count; k++) {
                    const GpTexelUse *use = &report.texel[k];
                    const GpLevel *level = &s->level[use->level];
                    assert_true(use->level < s->levels);
                    assert_true((use->x == -1 && use->y == -1 && mode == GP_BORDER) ||
                                (use->x >= 0 && use->x < (int32_t)level->width && use->y >= 0 &&
                                 use->y < (int32_t)level->height));
                }
                for (int c = 0; c < 4; c++)
                    assert_true(rgba[c] >= 0.0f && rgba[c] <= 1.0f);
            }
        gp_surface_destroy(&s);
    }
}

/* --- reports ---------------------------------------------------------------------------------- */

static void a_report_explains_its_sample(void **state)
{
    (void)state;
    Random seed = { 8 };
    for (GpFormat format = GP_A8R8G8B8; format < GP_D16; format++) {
        GpSurface *s = make(format, 8, 4, GP_MAX_LEVELS);
        for (uint32_t l = 0; l < s->levels; l++)
            for (uint32_t t = 0; t < s->level[l].width * s->level[l].height; t++) {
                float color[4];
                for (int c = 0; c < 4; c++)
                    color[c] = (float)(random_word(&seed) >> 8) * 0x1p-24f;
                put(s, l, t % s->level[l].width, t / s->level[l].width, color);
            }
        GpTexture texture = linear(s, GP_BORDER);
        texture.sampler.mip = GP_MIP_LINEAR;
        for (int i = 0; i < 2000; i++) {
            float uvr[3] = { (float)(random_word(&seed) >> 8) * 0x1p-23f - 0.5f,
                             (float)(random_word(&seed) >> 8) * 0x1p-23f - 0.5f, 0 };
            float lod = (float)(random_word(&seed) >> 8) * 0x1p-22f, rgba[4], again[4];
            GpSampleReport report;
            gp_texture_sample(&texture, uvr, lod, rgba, &report);
            gp_texture_sample(&texture, uvr, lod, again, NULL);
            assert_memory_equal(rgba, again, sizeof rgba);
            assert_true(report.lod * 256.0f == nearbyintf(lod * 256.0f));
            assert_int_equal(report.magnified, lod <= 0.0f);

            double weight = 0, sum[4] = { 0 };
            for (int k = 0; k < report.count; k++) {
                const GpTexelUse *use = &report.texel[k];
                assert_true(use->weight > 0.0f);
                weight += (double)use->weight;
                float value[4] = { 0, 0, 0, 0 };
                if (use->x >= 0)
                    gp_texel_load(
                        format, texel_at(s, use->level, (uint32_t)use->x, (uint32_t)use->y), value);
                for (int c = 0; c < 4; c++) {
                    if (use->x >= 0)
                        assert_float_bits(use->value[c], value[c]);
                    sum[c] += (double)use->weight * (double)use->value[c];
                }
            }
            assert_true(weight == 1.0);
            for (int c = 0; c < 4; c++)
                assert_true(fabs(sum[c] - (double)rgba[c]) < 3e-7);
        }
        gp_surface_destroy(&s);
    }
}

static void a_point_report_names_one_texel(void **state)
{
    (void)state;
    GpSurface *s = make_random(GP_A8R8G8B8, 4, (Random){ 11 });
    GpTexture texture = { .surface = s };
    const float uvr[3] = { 0.8f, 0.3f, 0 };
    float rgba[4];
    GpSampleReport report;
    gp_texture_sample(&texture, uvr, 0, rgba, &report);
    assert_int_equal(report.count, 1);
    assert_int_equal(report.texel[0].x, 3);
    assert_int_equal(report.texel[0].y, 1);
    assert_int_equal(report.texel[0].level, 0);
    assert_true(report.texel[0].weight == 1.0f);
    assert_memory_equal(report.texel[0].value, rgba, sizeof rgba);
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
        cmocka_unit_test(r49_sixteen_patterns_by_all_weights),
        cmocka_unit_test(r49_point_gives_zero_or_one),
        cmocka_unit_test(r49_both_sides_are_compared_as_stored_codes),
        cmocka_unit_test(r49_d32f_is_compared_as_floats),
        cmocka_unit_test(r49_the_reference_is_clamped),
        cmocka_unit_test(r49_the_border_is_a_depth),
        cmocka_unit_test(r41_the_border_wins_if_any_axis_is_out),
        cmocka_unit_test(the_border_is_a_texel_of_the_format),
        cmocka_unit_test(missing_channels_sample_as_one_also_at_the_border),
        cmocka_unit_test(an_unbound_texture_is_opaque_black),
        cmocka_unit_test(r43_mip_filters_blend_levels_by_the_8_bit_fraction),
        cmocka_unit_test(r44_magnification_and_minification_use_their_filters),
        cmocka_unit_test(nan_texels_propagate_but_only_with_a_weight),
        cmocka_unit_test(odd_coordinates_and_lods_stay_inside),
        cmocka_unit_test(a_report_explains_its_sample),
        cmocka_unit_test(a_point_report_names_one_texel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
