/* Pictures whose bytes are known: orders of rows and channels, alpha, palettes, passes. */
#include "tests/support/image_case.h"

#include <zlib.h>

static void ppm_and_pgm_are_big_endian_from_the_top(void **state)
{
    (void)state;
    GpImage image;
    static const char ppm[] = "P6 # comment\n2 2\n255\nabcdefghijkl";
    assert_reads(put_file("a.ppm", ppm, sizeof ppm - 1), &image);
    assert_int_equal(image.channels, 3);
    assert_memory_equal(image.data, "abcdefghijkl", 12);
    gp_image_free(&image);

    static const char pgm[] = "P5\n1 2\n65535\n\x12\x34\xab\xcd";
    assert_reads(put_file("a.pgm", pgm, sizeof pgm - 1), &image);
    assert_int_equal(image.type, GP_IMAGE_U16);
    assert_int_equal(((uint16_t *)image.data)[0], 0x1234);
    assert_int_equal(((uint16_t *)image.data)[1], 0xabcd);
    gp_image_free(&image);
}

static void pfm_rows_come_from_the_bottom_in_either_byte_order(void **state)
{
    (void)state;
    GpImage image;
    static const char little[] = "Pf\n1 2\n-1.0\n\0\0\x80\x3f\0\0\0\xc0";
    static const char big[] = "Pf\n1 2\n1\n\x3f\x80\0\0\xc0\0\0\0";
    for (int i = 0; i < 2; i++) {
        assert_reads(i == 0 ? put_file("a.pfm", little, sizeof little - 1)
                            : put_file("a.pfm", big, sizeof big - 1),
                     &image);
        assert_true(((float *)image.data)[0] == -2.0f); /* top */
        assert_true(((float *)image.data)[1] == 1.0f);  /* bottom */
        gp_image_free(&image);
    }
}

static void tga_origin_order_and_alpha_are_as_stored(void **state)
{
    (void)state;
    /* 1x2, 32 bits, origin at the bottom, b g r a; a small alpha beside bright colours. */
    unsigned char tga[26] = { 0,
                              0,
                              2,
                              [12] = 1,
                              [14] = 2,
                              [16] = 32,
                              [17] = 8,
                              /* bottom */ 30,
                              20,
                              10,
                              1,
                              /* top */ 250,
                              240,
                              230,
                              2 };
    GpImage image;
    assert_reads(put_file("a.tga", tga, sizeof tga), &image);
    static const uint8_t expected[8] = { 230, 240, 250, 2, 10, 20, 30, 1 };
    assert_int_equal(image.channels, 4);
    assert_memory_equal(image.data, expected, 8);
    gp_image_free(&image);

    tga[17] = 0x28; /* origin at the top */
    assert_reads(put_file("a.tga", tga, sizeof tga), &image);
    assert_memory_equal(image.data, expected + 4, 4);
    gp_image_free(&image);
}

static void png_alpha_is_not_multiplied_into_colours(void **state)
{
    (void)state;
    GpImage image;
    static const uint8_t expected[8] = { 200, 100, 50, 1, 7, 8, 9, 0 };
    assert_reads(put_file("a.png", tiny_png, sizeof tiny_png), &image);
    assert_int_equal(image.channels, 4);
    assert_int_equal(image.height, 2);
    assert_memory_equal(image.data, expected, 8);
    gp_image_free(&image);
}

/* What a PNG file may hold beside the four kinds that are written here. */
typedef struct PngCase {
    const char *name;
    uint8_t width, height, bits, color, interlaced;
    const char *rows, *palette, *transparent; /* hexadecimal; rows with their filters */
    uint32_t channels;
    const char *samples; /* expected, of `type`, the most significant byte first */
    GpImageType type;
} PngCase;

static size_t bytes_of_hex(const char *text, uint8_t *bytes)
{
    size_t size = 0;
    for (int used; sscanf(text, "%2hhx%n", &bytes[size], &used) == 1; text += used)
        size++;
    return size;
}

static uint8_t *put_big(uint8_t *at, uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        *at++ = (uint8_t)(value >> shift);
    return at;
}

static uint8_t *put_chunk(uint8_t *at, const char *name, const uint8_t *data, size_t size)
{
    uint8_t *begin = put_big(at, (uint32_t)size);
    memcpy(begin, name, 4);
    if (size > 0)
        memcpy(begin + 4, data, size);
    return put_big(begin + 4 + size, (uint32_t)crc32(0, begin, (uInt)(4 + size)));
}

static const char *put_png(const PngCase *one)
{
    uint8_t file[512] = { 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n' }, *at = file + 8;
    uint8_t bytes[128], packed[256];
    const uint8_t header[13] = { 0,          0, 0, one->width,     0, 0, 0, one->height, one->bits,
                                 one->color, 0, 0, one->interlaced };
    at = put_chunk(at, "IHDR", header, sizeof header);
    if (one->palette)
        at = put_chunk(at, "PLTE", bytes, bytes_of_hex(one->palette, bytes));
    if (one->transparent)
        at = put_chunk(at, "tRNS", bytes, bytes_of_hex(one->transparent, bytes));
    uLongf size = sizeof packed;
    assert_int_equal(compress(packed, &size, bytes, bytes_of_hex(one->rows, bytes)), Z_OK);
    at = put_chunk(at, "IDAT", packed, size);
    at = put_chunk(at, "IEND", NULL, 0);
    return put_file("a.png", file, (size_t)(at - file));
}

static void png_samples_are_expanded_and_passes_joined(void **state)
{
    (void)state;
    enum { GREY = 0, COLOR = 2, PALETTE = 3 };
    static const PngCase cases[] = {
        { "1 bit", 5, 1, 1, GREY, 0, "00 b0", NULL, NULL, 1, "ff 00 ff ff 00", GP_IMAGE_U8 },
        { "2 bits", 4, 1, 2, GREY, 0, "00 1b", NULL, NULL, 1, "00 55 aa ff", GP_IMAGE_U8 },
        { "4 bits", 2, 1, 4, GREY, 0, "00 5f", NULL, NULL, 1, "55 ff", GP_IMAGE_U8 },
        { "16 bits", 2, 1, 16, GREY, 0, "00 1234 fffe", NULL, NULL, 1, "1234 fffe", GP_IMAGE_U16 },
        { "palette", 3, 1, 2, PALETTE, 0, "00 18", "010203 040506 070809", NULL, 3,
          "010203 040506 070809", GP_IMAGE_U8 },
        { "palette and alpha", 3, 1, 2, PALETTE, 0, "00 18", "010203 040506 070809", "00 80", 4,
          "01020300 04050680 070809ff", GP_IMAGE_U8 },
        { "a transparent grey", 2, 1, 8, GREY, 0, "00 07 08", NULL, "0007", 2, "0700 08ff",
          GP_IMAGE_U8 },
        { "a transparent colour", 2, 1, 8, COLOR, 0, "00 010203 010204", NULL, "0001 0002 0003", 4,
          "01020300 010204ff", GP_IMAGE_U8 },
        { "sums of the row above", 2, 2, 8, GREY, 0, "00 10 20  02 01 f0", NULL, NULL, 1,
          "10 20 11 10", GP_IMAGE_U8 },
        { "seven passes", 3, 3, 8, GREY, 1, "00 0a  00 0c  00 20 22  00 0b  00 21  00 1a 1b 1c",
          NULL, NULL, 1, "0a 0b 0c 1a 1b 1c 20 21 22", GP_IMAGE_U8 },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        const PngCase *one = &cases[i];
        GpImage image;
        uint8_t expected[64];
        size_t size = bytes_of_hex(one->samples, expected);
        assert_reads(put_png(one), &image);
        if (one->type == GP_IMAGE_U16)
            for (size_t k = 0; k < size; k += 2) {
                uint16_t sample = (uint16_t)(expected[k] << 8 | expected[k + 1]);
                memcpy(expected + k, &sample, sizeof sample);
            }
        if (image.type != one->type || image.channels != one->channels ||
            image_bytes(&image) != size || memcmp(image.data, expected, size) != 0)
            fail_msg("%s", one->name);
        gp_image_free(&image);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)
    const struct CMUnitTest tests[] = {
        TEST(ppm_and_pgm_are_big_endian_from_the_top),
        TEST(pfm_rows_come_from_the_bottom_in_either_byte_order),
        TEST(tga_origin_order_and_alpha_are_as_stored),
        TEST(png_alpha_is_not_multiplied_into_colours),
        TEST(png_samples_are_expanded_and_passes_joined),
    };
    return cmocka_run_group_tests_name("image bytes", tests, NULL, NULL);
}
