/* Depth comparison by texture reads (R49). */
#include <math.h>

#include "tests/support/texture_case.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r49_sixteen_patterns_by_all_weights),
        cmocka_unit_test(r49_point_gives_zero_or_one),
        cmocka_unit_test(r49_both_sides_are_compared_as_stored_codes),
        cmocka_unit_test(r49_d32f_is_compared_as_floats),
        cmocka_unit_test(r49_the_reference_is_clamped),
        cmocka_unit_test(r49_the_border_is_a_depth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
