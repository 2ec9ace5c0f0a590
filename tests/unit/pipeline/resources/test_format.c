/* Texels of all formats, whole and by channels (R31, R37); what formats are called and told to
 * be. */
#include "pipeline/resources/format.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#define assert_float_bits(a, b) assert_int_equal(gp_float_bits(a), gp_float_bits(b))

static void r31_every_code_of_8_and_16_bit_channels_round_trips(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_A8R8G8B8_SRGB, GP_R8, GP_G16R16F,
                                        GP_A16B16G16R16F };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        const GpFormatInfo *info = gp_format_info(formats[f]);
        size_t bytes = info->bytes, channel = bytes / info->channels;
        for (uint32_t code = 0; code < 1u << 8 * channel; code++) {
            if (info->is_float && (code & 0x7c00) == 0x7c00 && code & 0x3ff)
                continue; /* NaN: below */
            uint8_t texel[16], back[16];
            for (size_t i = 0; i < bytes; i += channel) {
                uint32_t other = code + (uint32_t)i * 0x1111; /* another code in each channel */
                if ((other & 0x7c00) == 0x7c00)
                    other = code;
                for (size_t b = 0; b < channel; b++)
                    texel[i + b] = (uint8_t)(other >> 8 * b);
            }
            float rgba[4];
            memset(back, 0xaa, sizeof back);
            gp_texel_load(formats[f], texel, rgba);
            gp_texel_store(formats[f], back, rgba, 0);
            assert_memory_equal(texel, back, bytes);
            for (size_t i = bytes; i < sizeof back; i++)
                assert_int_equal(back[i], 0xaa); /* and nothing behind the texel is touched */
        }
    }
}

static void r31_depth_texels_round_trip(void **state)
{
    (void)state;
    for (uint32_t code = 0; code < 65536; code++) {
        assert_int_equal(gp_depth_code(GP_D16, gp_depth_from_code(GP_D16, code)), code);
        uint8_t texel[3] = { 0, 0, 0xaa }, stencil = 9;
        uint32_t back;
        gp_depth_store(GP_D16, texel, code, 7);
        gp_depth_load(GP_D16, texel, &back, &stencil);
        assert_int_equal(back, code);
        assert_int_equal(stencil, 0);
        assert_int_equal(texel[2], 0xaa);
    }
    Random seed = { 31 };
    for (int i = 0; i < 100000; i++) {
        uint32_t word = random_word(&seed), code;
        uint8_t texel[4], stencil;
        gp_depth_store(GP_D24S8, texel, word >> 8, (uint8_t)word);
        gp_depth_load(GP_D24S8, texel, &code, &stencil);
        assert_int_equal(code, word >> 8);
        assert_int_equal(stencil, word & 255);
        gp_depth_store(GP_D32F, texel, word, 7);
        gp_depth_load(GP_D32F, texel, &code, &stencil);
        assert_int_equal(code, word);
        assert_int_equal(stencil, 0);
    }
}

static void r31_floats_round_trip_and_nan_is_canonical(void **state)
{
    (void)state;
    static const uint32_t nans[] = { 0x7f800001u, 0x7fbfffffu, 0xffc00000u, 0xffffffffu,
                                     0x7fc00000u };
    static const GpFormat formats[] = { GP_R32F, GP_A32B32G32R32F };
    Random seed = { 32 };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        size_t bytes = gp_format_info(formats[f])->bytes;
        for (int i = 0; i < 50000; i++) {
            uint32_t words[4];
            for (int c = 0; c < 4; c++)
                words[c] = random_word(&seed) % 0x7f800001u | (random_word(&seed) & 0x80000000u);
            uint8_t texel[16], back[16];
            for (int b = 0; b < 16; b++)
                texel[b] = (uint8_t)(words[b / 4] >> 8 * (b % 4));
            float rgba[4];
            gp_texel_load(formats[f], texel, rgba);
            gp_texel_store(formats[f], back, rgba, 0);
            assert_memory_equal(texel, back, bytes);
        }
    }
    for (size_t i = 0; i < GP_COUNT(nans); i++) {
        float nan = gp_bits_float(nans[i]), rgba[4] = { nan, nan, nan, nan };
        uint8_t texel[16];
        gp_texel_store(GP_A32B32G32R32F, texel, rgba, 0);
        for (int b = 0; b < 16; b++)
            assert_int_equal(texel[b], (uint8_t)(0x7fc00000u >> 8 * (b % 4)));
        gp_texel_store(GP_A16B16G16R16F, texel, rgba, 0);
        for (int b = 0; b < 8; b++)
            assert_int_equal(texel[b], b % 2 ? 0x7e : 0x00);
        gp_texel_store(GP_A8R8G8B8, texel, rgba, 0);
        for (int b = 0; b < 4; b++)
            assert_int_equal(texel[b], 0);
    }
}

/* The channel of each byte of a texel, least significant first, as the format's name says. */
static const struct {
    GpFormat format;
    const char *channel_of_byte;
} byte_layouts[] = {
    { GP_A8R8G8B8, "bgra" },
    { GP_A8R8G8B8_SRGB, "bgra" },
    { GP_R8, "r" },
    { GP_G16R16F, "rrgg" },
    { GP_A16B16G16R16F, "rrggbbaa" },
    { GP_R32F, "rrrr" },
    { GP_A32B32G32R32F, "rrrrggggbbbbaaaa" },
};

static void channels_lie_in_memory_as_the_format_is_named(void **state)
{
    (void)state;
    for (size_t f = 0; f < GP_COUNT(byte_layouts); f++) {
        const char *layout = byte_layouts[f].channel_of_byte;
        assert_int_equal(gp_format_info(byte_layouts[f].format)->bytes, strlen(layout));
        for (int c = 0; c < 4; c++) {
            float zero[4] = { 0 }, one[4] = { 0 };
            one[c] = 1.0f + 0x1p-9f + 0x1p-16f; /* changes each byte of a float */
            uint8_t before[16], after[16];
            gp_texel_store(byte_layouts[f].format, before, zero, 0);
            gp_texel_store(byte_layouts[f].format, after, one, 0);
            for (size_t b = 0; b < strlen(layout); b++)
                if (layout[b] != "rgba"[c])
                    assert_int_equal(before[b], after[b]);
            const char *last = strrchr(layout, "rgba"[c]); /* the top byte of 1.0 is never 0 */
            if (last)
                assert_int_not_equal(after[last - layout], 0);
        }
    }
    uint8_t texel[4];
    gp_depth_store(GP_D24S8, texel, 0x123456, 0x78);
    assert_memory_equal(texel, "\x78\x56\x34\x12", 4);
}

static void r37_kept_channels_keep_their_bits(void **state)
{
    (void)state;
    Random seed = { 37 };
    for (size_t f = 0; f < GP_COUNT(byte_layouts); f++) {
        GpFormat format = byte_layouts[f].format;
        const char *layout = byte_layouts[f].channel_of_byte;
        for (unsigned keep = 0; keep < 16; keep++) {
            for (int round = 0; round < 100; round++) {
                uint8_t before[16], masked[16], written[16];
                float rgba[4];
                for (int b = 0; b < 16; b++) /* any bits, NaN payloads too */
                    before[b] = masked[b] = (uint8_t)(random_word(&seed) >> 24);
                for (int c = 0; c < 4; c++)
                    rgba[c] = (float)(random_word(&seed) >> 8) * 0x1p-24f;
                gp_texel_store(format, written, rgba, 0);
                gp_texel_store(format, masked, rgba, keep);
                for (size_t b = 0; b < 16; b++) {
                    bool inside = b < strlen(layout);
                    bool kept = !inside || keep >> (strchr("rgba", layout[b]) - "rgba") & 1;
                    assert_int_equal(masked[b], kept ? before[b] : written[b]);
                }
            }
        }
    }
}

static void missing_channels_read_as_one(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        const GpFormatInfo *info = gp_format_info(format);
        int present = info->is_depth ? 1 : format == GP_L8 ? 3 : info->channels;
        uint8_t zeros[16] = { 0 };
        float rgba[4];
        gp_texel_load(format, zeros, rgba);
        for (int c = 0; c < 4; c++)
            assert_float_bits(rgba[c], c < present ? 0.0f : 1.0f);
        if (info->is_unorm8) {
            uint8_t code[4];
            gp_texel_codes(format, zeros, code);
            for (int c = 0; c < 4; c++)
                assert_int_equal(code[c], c < present ? 0 : 255);
        }
    }
}

static void unorm8_codes_are_the_bytes_by_channel(void **state)
{
    (void)state;
    uint8_t code[4];
    gp_texel_codes(GP_A8R8G8B8, "\x0b\x0c\x0d\x0e", code); /* b g r a */
    assert_memory_equal(code, "\x0d\x0c\x0b\x0e", 4);
    gp_texel_codes(GP_R8, "\x0b", code);
    assert_memory_equal(code, "\x0b\xff\xff\xff", 4);
    gp_texel_codes(GP_L8, "\x0b", code);
    assert_memory_equal(code, "\x0b\x0b\x0b\xff", 4);
    gp_texel_codes(GP_X8R8G8B8, "\x0b\x0c\x0d\x0e", code);
    assert_memory_equal(code, "\x0d\x0c\x0b\xff", 4);
}

/* Direct3D 9's L8 and X8R8G8B8: grey for all colours, alpha of 1 whatever the unused byte holds,
 * which a store fills. */
static void l8_is_grey_and_x8r8g8b8_opaque(void **state)
{
    (void)state;
    static const float color[4] = { 0.2f, 0.4f, 0.6f, 0.8f };
    uint8_t texel[4] = { 51, 7, 7, 7 };
    float rgba[4];
    gp_texel_load(GP_L8, texel, rgba);
    for (int c = 0; c < 4; c++)
        assert_true(rgba[c] == (c < 3 ? 0.2f : 1.0f));
    gp_texel_store(GP_L8, texel, color, 0);
    assert_memory_equal(texel, "\x33\x07\x07\x07", 4);
    gp_texel_load(GP_X8R8G8B8, "\x99\x66\x33\x12", rgba);
    assert_true(rgba[0] == 0.2f && rgba[1] == 0.4f && rgba[2] == 0.6f && rgba[3] == 1);
    gp_texel_store(GP_X8R8G8B8, texel, color, 0);
    assert_memory_equal(texel, "\x99\x66\x33\xff", 4);
}

static void texels_may_lie_at_any_address(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        uint8_t memory[32] = { 0 };
        float rgba[4] = { 0.25f, 0.5f, 0.75f, 1.0f }, even[4], odd[4];
        for (int offset = 0; offset < 2; offset++) {
            if (gp_format_info(format)->is_depth)
                gp_depth_store(format, memory + offset, gp_depth_code(format, 0.25f), 3);
            else
                gp_texel_store(format, memory + offset, rgba, 0);
            gp_texel_load(format, memory + offset, offset ? odd : even);
        }
        assert_memory_equal(even, odd, sizeof even);
    }
}

static void format_names_lead_back_to_formats(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++)
        assert_int_equal(gp_format_from_name(gp_format_info(format)->name), format);
    assert_int_equal(gp_format_from_name("a8r8g8b8"), GP_A8R8G8B8);
    assert_int_equal(gp_format_from_name("d24s8"), GP_D24S8);
    assert_int_equal(gp_format_from_name("A8R8G8"), GP_FORMAT_NONE);
    assert_int_equal(gp_format_from_name("A8R8G8B8 "), GP_FORMAT_NONE);
    assert_int_equal(gp_format_from_name(""), GP_FORMAT_NONE);
}

static void format_descriptions_do_not_contradict_themselves(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_FORMATS; format++) {
        const GpFormatInfo *info = gp_format_info(format);
        assert_int_equal(info->is_depth, info->channels == 0);
        assert_int_equal(info->is_depth, info->depth_bits != 0);
        assert_false(info->is_depth && info->is_target);
        assert_false(info->is_float && info->is_unorm8);
        if (info->is_unorm8)
            assert_int_equal(info->bytes, info->channels + (format == GP_X8R8G8B8));
        if (info->is_depth)
            assert_int_equal(info->bytes * 8, info->depth_bits + (info->has_stencil ? 8 : 0));
    }
    assert_false(gp_format_info(GP_A8R8G8B8_SRGB)->is_target);
    assert_false(gp_format_info(GP_L8)->is_target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r31_every_code_of_8_and_16_bit_channels_round_trips),
        cmocka_unit_test(r31_depth_texels_round_trip),
        cmocka_unit_test(r31_floats_round_trip_and_nan_is_canonical),
        cmocka_unit_test(channels_lie_in_memory_as_the_format_is_named),
        cmocka_unit_test(r37_kept_channels_keep_their_bits),
        cmocka_unit_test(missing_channels_read_as_one),
        cmocka_unit_test(unorm8_codes_are_the_bytes_by_channel),
        cmocka_unit_test(l8_is_grey_and_x8r8g8b8_opaque),
        cmocka_unit_test(texels_may_lie_at_any_address),
        cmocka_unit_test(format_names_lead_back_to_formats),
        cmocka_unit_test(format_descriptions_do_not_contradict_themselves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
