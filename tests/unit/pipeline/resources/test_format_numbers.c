/* Numbers of formats: every rounding between floats and stored bits (R19-R21, R23, R24,
 * R26-R28). */
#include <math.h>

#include "pipeline/resources/format.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#define assert_float_bits(a, b) assert_int_equal(gp_float_bits(a), gp_float_bits(b))

static float above(float value)
{
    return nextafterf(value, INFINITY);
}

static float below(float value)
{
    return nextafterf(value, -INFINITY);
}

/* floor(value * (2^bits - 1) + 1/2) for value in [0, 1], in integers: value = m / 2^e. */
static uint32_t exact_unorm(float value, int bits)
{
    int exponent;
    uint64_t m = (uint64_t)ldexpf(frexpf(value, &exponent), 24);
    int shift = 24 - exponent; /* value = m / 2^shift */
    if (m == 0 || shift > 60)
        return 0;
    uint64_t twice = 2 * m * ((1u << bits) - 1) + (1ull << shift);
    return (uint32_t)(twice >> (shift + 1));
}

/* --- unorm and depth -------------------------------------------------------------------------- */

static void r19_float_to_depth_adds_half_and_truncates(void **state)
{
    (void)state;
    Random seed = { 19 };
    for (int i = 0; i < 400000; i++) {
        /* Evenly spread values, and values of all sizes down to the denormals. */
        uint32_t random = random_word(&seed);
        float value = i & 1 ? (float)(random >> 8) * 0x1p-24f : gp_bits_float(random % 0x3f800001u);
        assert_int_equal(gp_depth_code(GP_D16, value), exact_unorm(value, 16));
        assert_int_equal(gp_depth_code(GP_D24S8, value), exact_unorm(value, 24));
    }
}

static void r19_codes_change_exactly_at_the_half_way_points(void **state)
{
    (void)state;
    for (uint32_t code = 1; code <= 65535; code++) {
        float middle = (float)(((double)code - 0.5) / 65535.0);
        for (float value = below(middle); value <= above(middle); value = above(value))
            assert_int_equal(gp_depth_code(GP_D16, value), exact_unorm(value, 16));
    }
}

static void r20_every_d24_code_round_trips(void **state)
{
    (void)state;
    uint32_t wrong = 0, wrong_in_binary32 = 0, out_of_range = 0;
    for (uint32_t code = 0; code < 1u << 24; code++) {
        float depth = gp_depth_from_code(GP_D24S8, code);
        wrong += gp_depth_code(GP_D24S8, depth) != code;
        uint32_t narrow = (uint32_t)(depth * 16777215.0f + 0.5f);
        out_of_range += narrow >> 24;
        wrong_in_binary32 += (narrow > 0xffffff ? 0xffffff : narrow) != code;
    }
    assert_int_equal(wrong, 0);
    /* What the rule warns of; and depth 1 would even become 2^24, were it not clamped again. */
    assert_int_equal(wrong_in_binary32, 4194303);
    assert_int_equal(out_of_range, 1);
}

static void r21_depth_codes_order_as_depths_do(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_D16, GP_D24S8, GP_D32F };
    Random seed = { 21 };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        for (int i = 0; i < 100000; i++) {
            float a = gp_bits_float(random_word(&seed) % 0x3f800001u);
            float b = i & 1 ? above(a) : (float)(random_word(&seed) >> 8) * 0x1p-24f;
            if (b > 1.0f)
                continue;
            uint32_t code_a = gp_depth_code(formats[f], a), code_b = gp_depth_code(formats[f], b);
            assert_true(a <= b ? code_a <= code_b : code_a >= code_b);
            if (formats[f] == GP_D32F)
                assert_int_equal(a < b, code_a < code_b);
        }
    }
}

static void r21_edges_of_depth(void **state)
{
    (void)state;
    assert_int_equal(gp_depth_code(GP_D16, 1.0f), 0xffff);
    assert_int_equal(gp_depth_code(GP_D24S8, 1.0f), 0xffffff);
    assert_int_equal(gp_depth_code(GP_D32F, 1.0f), 0x3f800000);
    assert_int_equal(gp_depth_code(GP_D32F, 0.0f), 0);
    assert_int_equal(gp_depth_code(GP_D32F, -0.0f), 0); /* not behind everything */
    assert_int_equal(gp_depth_code(GP_D16, NAN), 0);
    assert_int_equal(gp_depth_code(GP_D24S8, NAN), 0);
    assert_int_equal(gp_depth_code(GP_D32F, gp_bits_float(0xff812345u)), 0x7fc00000);
    for (uint32_t bits = 0; bits <= 0x3f800000u; bits += 4099)
        assert_int_equal(gp_depth_code(GP_D32F, gp_depth_from_code(GP_D32F, bits)), bits);
}

/* The nearest float is the one whose product with 2^n - 1 is nearest to the code; 24 by 24 bits are
 * exact in binary64. */
static void assert_nearest_unorm(uint32_t code, int bits)
{
    float value = gp_float_from_unorm(code, bits);
    double scale = (double)((1u << bits) - 1), target = (double)code;
    double error = fabs((double)value * scale - target);
    assert_true(error <= fabs((double)above(value) * scale - target));
    assert_true(error <= fabs((double)below(value) * scale - target));
}

static void r23_unorm_to_float_is_correctly_rounded(void **state)
{
    (void)state;
    for (int bits = 1; bits <= 16; bits++)
        for (uint32_t code = 0; code < 1u << bits; code++)
            assert_nearest_unorm(code, bits);
    for (int bits = 17; bits <= 24; bits++)
        for (uint32_t code = 0; code < 1u << bits; code += 37)
            assert_nearest_unorm(code, bits);
}

static void r23_a_reciprocal_would_be_wrong_for_126_codes(void **state)
{
    (void)state;
    int differ = 0;
    for (uint32_t code = 0; code < 256; code++)
        differ += gp_float_from_unorm(code, 8) != (float)code * (1.0f / 255.0f);
    assert_int_equal(differ, 126);
}

static void r24_float_to_unorm_round_trips_for_every_width(void **state)
{
    (void)state;
    for (int bits = 1; bits <= 24; bits++) {
        uint32_t step = bits <= 16 ? 1 : 61;
        for (uint32_t code = 0; code < 1u << bits; code += step)
            assert_int_equal(gp_unorm_from_float(gp_float_from_unorm(code, bits), bits), code);
        assert_float_bits(gp_float_from_unorm((1u << bits) - 1, bits), 1.0f);
        assert_float_bits(gp_float_from_unorm(0, bits), 0.0f);
    }
}

static void r24_float_to_unorm_is_exact_beside_every_boundary(void **state)
{
    (void)state;
    for (int bits = 1; bits <= 12; bits++) {
        double scale = (double)((1u << bits) - 1);
        for (uint32_t code = 1; code < 1u << bits; code++) {
            float middle = (float)(((double)code - 0.5) / scale);
            for (float value = below(middle); value <= above(middle); value = above(value))
                assert_int_equal(gp_unorm_from_float(value, bits), exact_unorm(value, bits));
        }
    }
    assert_int_equal(gp_unorm_from_float(0.5f, 1),
                     1); /* the one tie that is a float: away from 0 */
    assert_int_equal(gp_unorm_from_float(below(0.5f), 1), 0);
}

static void r24_float_to_unorm_clamps_and_nan_is_zero(void **state)
{
    (void)state;
    static const float low[] = { NAN, -NAN, -INFINITY, -1.0f, -0.0f, 0.0f, 0x1p-149f };
    static const float high[] = { 1.0f, 1.5f, 3e38f, INFINITY };
    for (int bits = 1; bits <= 24; bits++) {
        for (size_t i = 0; i < GP_COUNT(low); i++)
            assert_int_equal(gp_unorm_from_float(low[i], bits), 0);
        for (size_t i = 0; i < GP_COUNT(high); i++)
            assert_int_equal(gp_unorm_from_float(high[i], bits), (1u << bits) - 1);
    }
}

/* --- sRGB ------------------------------------------------------------------------------------- */

static long double srgb_decode(long double c)
{
    return c <= 0.04045L ? c / 12.92L : powl((c + 0.055L) / 1.055L, 2.4L);
}

static long double srgb_encode(long double c)
{
    return c <= 0.0031308L ? c * 12.92L : 1.055L * powl(c, 1.0L / 2.4L) - 0.055L;
}

static void r26_srgb_decode_is_correctly_rounded(void **state)
{
    (void)state;
    for (int code = 0; code < 256; code++) {
        float value = gp_linear_from_srgb8((uint8_t)code);
        long double exact = srgb_decode((long double)code / 255);
        long double error = fabsl((long double)value - exact);
        assert_true(error <= fabsl((long double)above(value) - exact));
        assert_true(error <= fabsl((long double)below(value) - exact));
    }
    assert_float_bits(gp_linear_from_srgb8(0), 0.0f);
    assert_float_bits(gp_linear_from_srgb8(255), 1.0f);
}

static void r26_srgb_round_trips_256_of_256(void **state)
{
    (void)state;
    for (int code = 0; code < 256; code++) {
        float linear = gp_linear_from_srgb8((uint8_t)code);
        assert_int_equal((int)(srgb_encode((long double)linear) * 255 + 0.5L), code);
        assert_int_equal(gp_srgb8_from_linear(linear), code);
    }
}

static void r26_srgb_encode_is_the_exact_curve(void **state)
{
    (void)state;
    for (uint32_t bits = 0; bits <= 0x3f800000u; bits += 4093) {
        float value = gp_bits_float(bits);
        int expected = (int)(srgb_encode((long double)value) * 255 + 0.5L);
        assert_int_equal(gp_srgb8_from_linear(value), expected);
    }
    /* Each code starts at the first float that reaches it. */
    for (int code = 1; code < 256; code++) {
        float first = (float)srgb_decode(((long double)code - 0.5L) / 255);
        for (float value = below(first); value <= above(first); value = above(value)) {
            int expected = (int)(srgb_encode((long double)value) * 255 + 0.5L);
            assert_int_equal(gp_srgb8_from_linear(value), expected);
        }
    }
    assert_int_equal(gp_srgb8_from_linear(NAN), 0);
    assert_int_equal(gp_srgb8_from_linear(-1.0f), 0);
    assert_int_equal(gp_srgb8_from_linear(INFINITY), 255);
}

static void r26_srgb_alpha_stays_linear(void **state)
{
    (void)state;
    for (int code = 0; code < 256; code++) {
        uint8_t texel[4] = { (uint8_t)code, (uint8_t)code, (uint8_t)code, (uint8_t)code };
        float rgba[4];
        gp_texel_load(GP_A8R8G8B8_SRGB, texel, rgba);
        for (int c = 0; c < 3; c++)
            assert_float_bits(rgba[c], gp_linear_from_srgb8((uint8_t)code));
        assert_float_bits(rgba[3], gp_float_from_unorm((uint32_t)code, 8));
    }
}

/* --- half ------------------------------------------------------------------------------------- */

/* The value of a finite half by the definition of the format. */
static double half_value(uint32_t half)
{
    int exponent = half >> 10 & 31, fraction = half & 1023;
    double size = exponent ? ldexp(1024 + fraction, exponent - 25) : ldexp(fraction, -24);
    return half & 0x8000 ? -size : size;
}

static void r27_float_to_half_rounds_to_nearest_even(void **state)
{
    (void)state;
    /* The point between two neighbours, and the floats on either side of it, for all of them. */
    for (uint32_t half = 0; half < 0x7bff; half++) {
        float middle = (float)(0.5 * (half_value(half) + half_value(half + 1)));
        for (uint32_t sign = 0; sign <= 0x8000; sign += 0x8000) {
            float s = sign ? -1.0f : 1.0f;
            assert_int_equal(gp_half_from_float(s * middle), sign | (half + (half & 1)));
            assert_int_equal(gp_half_from_float(s * below(middle)), sign | half);
            assert_int_equal(gp_half_from_float(s * above(middle)), sign | (half + 1));
        }
    }
}

static void r27_float_to_half_is_monotone(void **state)
{
    (void)state;
    uint16_t last = 0;
    for (uint32_t bits = 0; bits <= 0x7f800000u; bits += 1021) {
        uint16_t half = gp_half_from_float(gp_bits_float(bits));
        assert_true(half >= last);
        last = half;
    }
}

static void r27_overflow_of_half_starts_at_65520(void **state)
{
    (void)state;
    assert_int_equal(gp_half_from_float(65504.0f), 0x7bff);
    assert_int_equal(gp_half_from_float(65519.99f), 0x7bff);
    assert_int_equal(gp_half_from_float(below(65520.0f)), 0x7bff);
    assert_int_equal(gp_half_from_float(65520.0f), 0x7c00);
    assert_int_equal(gp_half_from_float(3e38f), 0x7c00);
    assert_int_equal(gp_half_from_float(-65520.0f), 0xfc00);
    assert_int_equal(gp_half_from_float(INFINITY), 0x7c00);
    assert_int_equal(gp_half_from_float(-INFINITY), 0xfc00);
}

static void r28_every_half_has_its_value_and_round_trips(void **state)
{
    (void)state;
    for (uint32_t half = 0; half < 65536; half++) {
        float value = gp_float_from_half((uint16_t)half);
        bool special = (half & 0x7c00) == 0x7c00;
        if (special && half & 0x3ff) {
            assert_int_equal(gp_float_bits(value), 0x7fc00000);
            assert_int_equal(gp_half_from_float(value), 0x7e00);
            continue;
        }
        if (special)
            assert_float_bits(value, half & 0x8000 ? -INFINITY : INFINITY);
        else
            assert_float_bits(value, (float)half_value(half)); /* denormals and -0 too */
        assert_int_equal(gp_half_from_float(value), half);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r19_float_to_depth_adds_half_and_truncates),
        cmocka_unit_test(r19_codes_change_exactly_at_the_half_way_points),
        cmocka_unit_test(r20_every_d24_code_round_trips),
        cmocka_unit_test(r21_depth_codes_order_as_depths_do),
        cmocka_unit_test(r21_edges_of_depth),
        cmocka_unit_test(r23_unorm_to_float_is_correctly_rounded),
        cmocka_unit_test(r23_a_reciprocal_would_be_wrong_for_126_codes),
        cmocka_unit_test(r24_float_to_unorm_round_trips_for_every_width),
        cmocka_unit_test(r24_float_to_unorm_is_exact_beside_every_boundary),
        cmocka_unit_test(r24_float_to_unorm_clamps_and_nan_is_zero),
        cmocka_unit_test(r26_srgb_decode_is_correctly_rounded),
        cmocka_unit_test(r26_srgb_round_trips_256_of_256),
        cmocka_unit_test(r26_srgb_encode_is_the_exact_curve),
        cmocka_unit_test(r26_srgb_alpha_stays_linear),
        cmocka_unit_test(r27_float_to_half_rounds_to_nearest_even),
        cmocka_unit_test(r27_float_to_half_is_monotone),
        cmocka_unit_test(r27_overflow_of_half_starts_at_65520),
        cmocka_unit_test(r28_every_half_has_its_value_and_round_trips),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
