/* Texture addressing and level of detail (R40-R44). */
#include <float.h>
#include <math.h>

#include "pipeline/units/texture.h"
#include "pipeline/units/texture_address.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

static const uint32_t sizes[] = { 1, 2, 3, 4, 5, 7, 16, 100, 255, 1024, 4095, 8191, 8192 };

/* The texels that a point sample at u reads, or -1. */
static int32_t point_texel(GpAddress mode, float u, uint32_t size)
{
    return gp_texel_address(mode, gp_texel_pair(mode, GP_POINT, u, size).first, size);
}

static void assert_pair(GpTexelPair pair, int32_t first, uint32_t share)
{
    assert_int_equal(pair.first, first);
    assert_int_equal(pair.share, share);
}

/* --- R40: positions --------------------------------------------------------------------------- */

static void r40_point_is_the_floor_of_the_8_bit_position(void **state)
{
    (void)state;
    /* All positions of an 8 texel axis in 4096ths of a texel, so that ties are among them. */
    for (int32_t step = -8 * 4096; step <= 16 * 4096; step++) {
        float u = (float)step / (8 * 4096.0f);
        double fixed = nearbyint((double)step / 16.0); /* 256ths, to nearest even */
        GpTexelPair pair = gp_texel_pair(GP_CLAMP, GP_POINT, u, 8);
        assert_pair(pair, (int32_t)floor(fixed / 256.0), 0);
    }
}

static void r40_linear_weight_is_the_8_bit_fraction_of_the_position_less_half(void **state)
{
    (void)state;
    for (int32_t step = -8 * 4096; step <= 16 * 4096; step++) {
        float u = (float)step / (8 * 4096.0f);
        double fixed = nearbyint((double)step / 16.0 - 128.0);
        double first = floor(fixed / 256.0);
        assert_pair(gp_texel_pair(GP_CLAMP, GP_LINEAR, u, 8), (int32_t)first,
                    (uint32_t)(fixed - 256.0 * first));
    }
}

static void r40_texel_centres_hit_their_texel_for_every_size(void **state)
{
    (void)state;
    for (size_t s = 0; s < GP_COUNT(sizes); s++) {
        for (uint32_t i = 0; i < sizes[s]; i++) {
            float u = ((float)i + 0.5f) / (float)sizes[s];
            for (GpAddress mode = GP_WRAP; mode < GP_ADDRESSES; mode++) {
                assert_pair(gp_texel_pair(mode, GP_POINT, u, sizes[s]), (int32_t)i, 0);
                assert_pair(gp_texel_pair(mode, GP_LINEAR, u, sizes[s]), (int32_t)i, 0);
            }
        }
    }
}

/* --- R41: address modes ----------------------------------------------------------------------- */

static void r41_address_modes_follow_the_table(void **state)
{
    (void)state;
    /* Size 3, texels -9 .. 9, written down by hand. */
    static const int32_t expected[GP_ADDRESSES][19] = {
        [GP_WRAP] = { 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0 },
        [GP_MIRROR] = { 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1, 2, 2 },
        [GP_CLAMP] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2, 2, 2 },
        [GP_BORDER] = { -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 1, 2, -1, -1, -1, -1, -1, -1, -1 },
        [GP_MIRROR_ONCE] = { 2, 2, 2, 2, 2, 2, 2, 1, 0, 0, 1, 2, 2, 2, 2, 2, 2, 2, 2 },
    };
    for (GpAddress mode = GP_WRAP; mode < GP_ADDRESSES; mode++)
        for (int32_t i = -9; i <= 9; i++)
            assert_int_equal(gp_texel_address(mode, i, 3), expected[mode][i + 9]);
}

static void r41_address_modes_have_their_symmetries_for_every_size(void **state)
{
    (void)state;
    for (uint32_t size = 1; size <= 40; size++) {
        int32_t n = (int32_t)size;
        for (int32_t i = -3 * n; i <= 3 * n; i++) {
            bool inside = i >= 0 && i < n;
            int32_t wrap = gp_texel_address(GP_WRAP, i, size);
            int32_t mirror = gp_texel_address(GP_MIRROR, i, size);
            int32_t once = gp_texel_address(GP_MIRROR_ONCE, i, size);
            for (GpAddress mode = GP_WRAP; mode < GP_ADDRESSES; mode++) {
                int32_t at = gp_texel_address(mode, i, size);
                assert_true(at >= (mode == GP_BORDER ? -1 : 0) && at < n);
                if (inside)
                    assert_int_equal(at, i);
            }
            assert_int_equal(wrap, gp_texel_address(GP_WRAP, i + n, size));
            assert_int_equal(mirror, gp_texel_address(GP_MIRROR, i + 2 * n, size));
            assert_int_equal(mirror, gp_texel_address(GP_MIRROR, -i - 1, size));
            assert_int_equal(once, gp_texel_address(GP_MIRROR_ONCE, -i - 1, size));
            if (i >= 0)
                assert_int_equal(once, gp_texel_address(GP_CLAMP, i, size));
            assert_int_equal(gp_texel_address(GP_CLAMP, i, size), i < 0 ? 0 : i < n ? i : n - 1);
            assert_int_equal(gp_texel_address(GP_BORDER, i, size), inside ? i : -1);
        }
    }
}

/* --- R42: range ------------------------------------------------------------------------------- */

static void r42_large_coordinates_keep_their_fraction(void **state)
{
    (void)state;
    /* 64ths of a period, all exact floats: 16 texels of 1024 each, wrapping after 64 of them and
     * mirroring with a period of 128. */
    for (int k = -1000; k <= 1000; k++) {
        for (int j = 0; j < 128; j++) {
            float far = (float)(k * 64) + (float)j / 64.0f;
            int32_t wrap = 16 * (j % 64), mirror = 16 * j;
            assert_pair(gp_texel_pair(GP_WRAP, GP_POINT, far, 1024), wrap, 0);
            assert_pair(gp_texel_pair(GP_MIRROR, GP_POINT, far, 1024), mirror, 0);
            assert_pair(gp_texel_pair(GP_WRAP, GP_LINEAR, far, 1024), wrap - 1, 128);
            assert_pair(gp_texel_pair(GP_MIRROR, GP_LINEAR, far, 1024), mirror - 1, 128);
            assert_int_equal(point_texel(GP_MIRROR, far, 1024), j < 64 ? mirror : 2047 - mirror);
        }
    }
    for (size_t s = 0; s < GP_COUNT(sizes); s++) {
        GpTexelPair near = gp_texel_pair(GP_WRAP, GP_LINEAR, 0.25f, sizes[s]);
        assert_pair(gp_texel_pair(GP_WRAP, GP_LINEAR, 1e6f + 0.25f, sizes[s]), near.first,
                    near.share);
        near = gp_texel_pair(GP_MIRROR, GP_LINEAR, 0.25f, sizes[s]);
        assert_pair(gp_texel_pair(GP_MIRROR, GP_LINEAR, 1e6f + 0.25f, sizes[s]), near.first,
                    near.share);
    }
}

static void r42_clamping_modes_stop_at_ten(void **state)
{
    (void)state;
    static const GpAddress modes[] = { GP_CLAMP, GP_BORDER, GP_MIRROR_ONCE };
    static const float far[] = { 10.5f, 1e6f, 3e38f, INFINITY };
    for (size_t m = 0; m < GP_COUNT(modes); m++) {
        for (size_t f = 0; f < GP_COUNT(far); f++) {
            for (float sign = -1.0f; sign <= 1.0f; sign += 2.0f) {
                GpTexelPair ten = gp_texel_pair(modes[m], GP_LINEAR, sign * 10.0f, 8192);
                GpTexelPair pair = gp_texel_pair(modes[m], GP_LINEAR, sign * far[f], 8192);
                assert_pair(pair, ten.first, ten.share);
            }
        }
    }
    assert_pair(gp_texel_pair(GP_CLAMP, GP_POINT, 10.0f, 8192), 81920, 0);
    assert_pair(gp_texel_pair(GP_CLAMP, GP_POINT, -10.0f, 8192), -81920, 0);
}

static void r42_nan_is_zero_and_nothing_leads_outside(void **state)
{
    (void)state;
    static const float odd[] = { NAN,        -NAN,    INFINITY, -INFINITY,       FLT_MAX,
                                 -FLT_MAX,   FLT_MIN, -FLT_MIN, 0x1p-149f,       -0x1p-149f,
                                 -0.0f,      -1e-9f,  0x1p24f,  -0x1.fffffep23f, 8388607.5f,
                                 -8388607.5f };
    for (size_t i = 0; i < GP_COUNT(odd); i++) {
        for (size_t s = 0; s < GP_COUNT(sizes); s++) {
            for (GpAddress mode = GP_WRAP; mode < GP_ADDRESSES; mode++) {
                for (int filter = GP_POINT; filter < GP_FILTERS; filter++) {
                    GpTexelPair pair = gp_texel_pair(mode, (GpFilter)filter, odd[i], sizes[s]);
                    assert_true(pair.share < 256);
                    for (int32_t k = 0; k < 2; k++) {
                        int32_t at = gp_texel_address(mode, pair.first + k, sizes[s]);
                        assert_true(at >= -1 && at < (int32_t)sizes[s]);
                        assert_true(at >= 0 || mode == GP_BORDER);
                    }
                    GpTexelPair zero = gp_texel_pair(mode, (GpFilter)filter, 0.0f, sizes[s]);
                    bool wraps = mode == GP_WRAP || mode == GP_MIRROR;
                    if (odd[i] != odd[i] || (wraps && isinf(odd[i])))
                        assert_pair(pair, zero.first, zero.share);
                }
            }
        }
    }
    assert_int_equal(point_texel(GP_CLAMP, INFINITY, 16), 15);
    assert_int_equal(point_texel(GP_CLAMP, -INFINITY, 16), 0);
    assert_int_equal(point_texel(GP_BORDER, INFINITY, 16), -1);
}

/* --- R43, R44: level of detail ---------------------------------------------------------------- */

static GpLevelPair levels_of(GpMipFilter mip, uint32_t levels, float lod)
{
    const GpSampler sampler = { .mip = mip };
    return gp_level_pair(&sampler, levels, lod);
}

static void r43_point_adds_half_and_truncates(void **state)
{
    (void)state;
    for (int32_t step = 0; step <= 12 * 4096; step++) { /* 4096ths of a level, ten levels */
        double fixed = nearbyint(step / 16.0);
        uint32_t level = (uint32_t)floor((fixed + 128.0) / 256.0);
        GpLevelPair pair = levels_of(GP_MIP_POINT, 10, (float)step / 4096.0f);
        assert_int_equal(pair.first, level > 9 ? 9 : level);
        assert_int_equal(pair.share, 0);
    }
}

static void r43_linear_uses_the_fraction_as_weight_without_snapping(void **state)
{
    (void)state;
    for (int32_t step = 0; step <= 12 * 4096; step++) {
        double fixed = nearbyint(step / 16.0);
        if (fixed > 9 * 256.0)
            fixed = 9 * 256.0;
        GpLevelPair pair = levels_of(GP_MIP_LINEAR, 10, (float)step / 4096.0f);
        assert_int_equal(pair.first * 256 + pair.share, (uint32_t)fixed);
        assert_true(pair.share == 0 || pair.first + 1 < 10);
    }
    assert_int_equal(levels_of(GP_MIP_LINEAR, 10, 3.0f + 1.0f / 256).share, 1);
    assert_int_equal(levels_of(GP_MIP_LINEAR, 10, 3.0f - 1.0f / 256).share, 255);
}

static void r43_no_mip_filter_reads_the_finest_level_allowed(void **state)
{
    (void)state;
    for (float lod = -3.0f; lod < 12.0f; lod += 0.37f) {
        GpSampler sampler = { .mip = GP_MIP_NONE };
        assert_int_equal(gp_level_pair(&sampler, 10, lod).first, 0);
        sampler.min_lod = 2.0f;
        assert_int_equal(gp_level_pair(&sampler, 10, lod).first, 2);
        assert_int_equal(gp_level_pair(&sampler, 2, lod).first, 1);
        assert_int_equal(gp_level_pair(&sampler, 10, lod).share, 0);
    }
}

static void r44_bias_comes_before_the_clamp_and_the_lower_bound_wins(void **state)
{
    (void)state;
    static const struct {
        float lod, bias, min, max, expected;
    } cases[] = {
        { 3.0f, 0.5f, 0.0f, 0.0f, 3.5f },  { 3.0f, 2.0f, 0.0f, 4.0f, 4.0f },
        { 3.0f, -4.0f, 0.0f, 4.0f, 0.0f }, { 3.0f, -4.0f, -2.0f, 4.0f, -1.0f },
        { 3.0f, -8.0f, 1.5f, 4.0f, 1.5f }, { 9.0f, 0.0f, 5.0f, 2.0f, 5.0f },
        { 1.0f, 0.0f, 5.0f, 2.0f, 5.0f },  { 9.0f, 0.0f, 0.0f, 0.0f, 9.0f },
        { 3.0f, 0.0f, 0.0f, -1.0f, 0.0f }, { 3.0f, 0.0f, -4.0f, -1.0f, -1.0f },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        const GpSampler sampler = { .mip = GP_MIP_LINEAR,
                                    .lod_bias = cases[i].bias,
                                    .min_lod = cases[i].min,
                                    .max_lod = cases[i].max };
        assert_true(gp_level_pair(&sampler, 14, cases[i].lod).lod == cases[i].expected);
    }
}

static void r44_an_upper_bound_of_0_is_one_where_it_is_said(void **state)
{
    (void)state;
    GpSampler sampler = { .mip = GP_MIP_LINEAR };
    assert_true(gp_level_pair(&sampler, 14, 3.0f).lod == 3.0f);
    sampler.has_max_lod = true;
    assert_true(gp_level_pair(&sampler, 14, 3.0f).lod == 0.0f);
    assert_true(gp_level_pair(&sampler, 14, 3.0f).magnified);
    sampler.max_lod = 2.0f;
    assert_true(gp_level_pair(&sampler, 14, 3.0f).lod == 2.0f);
}

static void r44_magnifies_if_and_only_if_the_clamped_lod_is_not_positive(void **state)
{
    (void)state;
    GpSampler sampler = { .mip = GP_MIP_LINEAR, .min_lod = -100.0f };
    assert_true(gp_level_pair(&sampler, 4, 0.0f).magnified);
    assert_true(gp_level_pair(&sampler, 4, -0.0f).magnified);
    assert_true(gp_level_pair(&sampler, 4, -3.0f).magnified);
    assert_true(gp_level_pair(&sampler, 4, -INFINITY).magnified);
    assert_false(gp_level_pair(&sampler, 4, 0x1p-149f).magnified); /* although its 8.8 form is 0 */
    assert_false(gp_level_pair(&sampler, 4, 1.0f).magnified);
    sampler.lod_bias = -1.0f;
    assert_true(gp_level_pair(&sampler, 4, 1.0f).magnified);
    sampler.min_lod = 0.5f; /* the clamp decides, not the footprint */
    assert_false(gp_level_pair(&sampler, 4, -3.0f).magnified);
}

static void r44_odd_lods_choose_a_level_that_exists(void **state)
{
    (void)state;
    static const float odd[] = { NAN,    -NAN,     INFINITY, -INFINITY, FLT_MAX,   -FLT_MAX,
                                 128.0f, 127.998f, -128.0f,  -128.01f,  0x1p-149f, 0.0f };
    for (size_t i = 0; i < GP_COUNT(odd); i++)
        for (size_t j = 0; j < GP_COUNT(odd); j++)
            for (int field = 0; field < 4; field++)
                for (int mip = GP_MIP_NONE; mip < GP_MIP_FILTERS; mip++)
                    for (uint32_t levels = 1; levels <= GP_MAX_LEVELS; levels++) {
                        GpSampler sampler = { .mip = (GpMipFilter)mip };
                        sampler.lod_bias = field == 1 ? odd[j] : 0.0f;
                        sampler.min_lod = field == 2 ? odd[j] : 0.0f;
                        sampler.max_lod = field == 3 ? odd[j] : 0.0f;
                        GpLevelPair pair = gp_level_pair(&sampler, levels, odd[i]);
                        assert_true(pair.share < 256);
                        assert_true(pair.first + (pair.share > 0) < levels);
                        assert_true(pair.lod >= -128.0f && pair.lod < 128.0f);
                    }
    assert_true(levels_of(GP_MIP_LINEAR, 5, NAN).lod == 0.0f);
    assert_int_equal(levels_of(GP_MIP_LINEAR, 5, INFINITY).first, 4);
}

static void r44_lod_is_log2_of_the_longer_axis(void **state)
{
    (void)state;
    for (int k = -10; k <= 10; k++) { /* a pixel steps over 2^k texels: exact */
        float step = ldexpf(1.0f, k);
        const float along_u[2] = { step / 256.0f, 0 }, along_v[2] = { 0, step / 64.0f };
        const float shorter[2] = { 0.5f * step / 256.0f, 0 }, none[2] = { 0 };
        assert_true(gp_texture_lod(along_u, none, 256, 64) == (float)k);
        assert_true(gp_texture_lod(none, along_u, 256, 64) == (float)k);
        assert_true(gp_texture_lod(along_v, none, 256, 64) == (float)k);
        assert_true(gp_texture_lod(along_u, shorter, 256, 64) == (float)k);
        assert_true(gp_texture_lod(shorter, along_v, 256, 64) == (float)k);
    }
    Random random = { 44 };
    for (int i = 0; i < 20000; i++) {
        float d[4];
        for (int c = 0; c < 4; c++) {
            const int exponent = random_int(&random, -10, 5);
            d[c] = ldexpf(random_float(&random, -1, 1), exponent);
        }
        double x = hypot((double)d[0] * 300, (double)d[1] * 200);
        double y = hypot((double)d[2] * 300, (double)d[3] * 200);
        double exact = log2(x > y ? x : y);
        assert_true(fabs((double)gp_texture_lod(d, d + 2, 300, 200) - exact) < 2e-6);
    }
}

static void r44_lod_of_odd_derivatives(void **state)
{
    (void)state;
    const float none[2] = { 0, 0 }, nan[2] = { 0, NAN }, one[2] = { 1, 1 };
    const float infinite[2] = { INFINITY, 0 }, largest[2] = { FLT_MAX, -FLT_MAX };
    assert_true(gp_texture_lod(none, none, 16, 16) == -INFINITY);
    assert_true(gp_texture_lod(nan, one, 16, 16) == 0.0f);
    assert_true(gp_texture_lod(one, nan, 16, 16) == 0.0f);
    assert_true(gp_texture_lod(nan, infinite, 16, 16) == 0.0f);
    assert_true(gp_texture_lod(infinite, none, 16, 16) <= 64.0f);
    assert_true(gp_texture_lod(none, largest, 8192, 8192) <= 64.0f);
    assert_true(gp_texture_lod(none, largest, 8192, 8192) > 63.9f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r40_point_is_the_floor_of_the_8_bit_position),
        cmocka_unit_test(r40_linear_weight_is_the_8_bit_fraction_of_the_position_less_half),
        cmocka_unit_test(r40_texel_centres_hit_their_texel_for_every_size),
        cmocka_unit_test(r41_address_modes_follow_the_table),
        cmocka_unit_test(r41_address_modes_have_their_symmetries_for_every_size),
        cmocka_unit_test(r42_large_coordinates_keep_their_fraction),
        cmocka_unit_test(r42_clamping_modes_stop_at_ten),
        cmocka_unit_test(r42_nan_is_zero_and_nothing_leads_outside),
        cmocka_unit_test(r43_point_adds_half_and_truncates),
        cmocka_unit_test(r43_linear_uses_the_fraction_as_weight_without_snapping),
        cmocka_unit_test(r43_no_mip_filter_reads_the_finest_level_allowed),
        cmocka_unit_test(r44_bias_comes_before_the_clamp_and_the_lower_bound_wins),
        cmocka_unit_test(r44_an_upper_bound_of_0_is_one_where_it_is_said),
        cmocka_unit_test(r44_magnifies_if_and_only_if_the_clamped_lod_is_not_positive),
        cmocka_unit_test(r44_odd_lods_choose_a_level_that_exists),
        cmocka_unit_test(r44_lod_is_log2_of_the_longer_axis),
        cmocka_unit_test(r44_lod_of_odd_derivatives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
