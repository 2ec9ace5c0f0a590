/* Textures: borders, channels that are missing, levels, coordinates out of range, sample reports
 * (R41, R43, R44, R48). */
#include <float.h>
#include <math.h>

#include "tests/support/texture_case.h"

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

static void r41_the_border_of_a_depth_texture_is_a_depth(void **state)
{
    (void)state;
    static const float given[] = { -0.5f, 0, 0.25f, 1, 1.5f }, stored[] = { 0, 0, 0.25f, 1, 1 };
    GpSurface *s = make(GP_D32F, 2, 2, 1);
    for (size_t i = 0; i < GP_COUNT(given); i++) {
        GpTexture texture = linear(s, GP_BORDER);
        texture.sampler.border[0] = given[i];
        float rgba[4];
        sample(&texture, 3.0f, 3.0f, 0, rgba);
        assert_true(rgba[0] == stored[i]);
    }
    gp_surface_destroy(&s);
}

static void missing_channels_sample_as_one_also_at_the_border(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        const GpFormatInfo *info = gp_format_info(format);
        /* luminance is all three colours */
        int present = info->is_depth ? 1 : format == GP_L8 ? 3 : info->channels;
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
        cmocka_unit_test(r41_the_border_wins_if_any_axis_is_out),
        cmocka_unit_test(the_border_is_a_texel_of_the_format),
        cmocka_unit_test(r41_the_border_of_a_depth_texture_is_a_depth),
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
