/* Volumes in files: what is written is read again, what is wrong is refused with its place, and a
 * file cannot ask for more than it holds. */
#include "pipeline/io/file.h"
#include "pipeline/io/volume/volume_file.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

#include <zlib.h>

static GpError error;

static void read_well(const char *path, GpVolume *volume)
{
    error.text[0] = '\0';
    if (gp_volume_read(path, volume, &error))
        fail_msg("%s", error.text);
}

static void assert_refused(const char *path, GpResult expected, const char *part)
{
    GpVolume volume = { .dims = { 77 } };
    GpResult result = gp_volume_read(path, &volume, &error);
    if (result != expected || !strstr(error.text, part))
        fail_msg("%s instead of %s: %s (expected: %s)", gp_result_name(result),
                 gp_result_name(expected), error.text, part);
    assert_int_equal(volume.dims[0], 77);
    assert_null(volume.data);
}

/* Any samples; of bits beyond the last, zeros. */
static GpVolume random_volume(GpVolumeType type, uint32_t x, uint32_t y, uint32_t z)
{
    Random random = { 5 + (uint64_t)type };
    GpVolume volume = { .dims = { x, y, z },
                        .type = type,
                        .spacing = { 1, 0.1, 2.5 },
                        .origin = { 450000.1, -1e-9, 0 } };
    size_t bytes = gp_volume_bytes(&volume), samples = (size_t)x * y * z;
    uint8_t *data = gp_alloc(bytes, 1);
    for (size_t i = 0; i < bytes; i++)
        data[i] = (uint8_t)random_int(&random, 0, 255);
    if (type == GP_VOLUME_BITS && samples % 8)
        data[bytes - 1] = (uint8_t)(data[bytes - 1] & ((1u << samples % 8) - 1));
    volume.data = data;
    return volume;
}

/* --- round trips ------------------------------------------------------------------------------ */

static void samples_of_every_type_come_back_from_nrrd(void **state)
{
    (void)state;
    const GpVolumeType types[] = { GP_VOLUME_U8, GP_VOLUME_U16, GP_VOLUME_I16, GP_VOLUME_F32 };
    for (size_t i = 0; i < GP_COUNT(types); i++) {
        GpVolume written = random_volume(types[i], 7, 5, 3), read;
        assert_int_equal(gp_volume_write(in_folder("v.NRRD"), &written, &error), GP_OK);
        read_well(in_folder("v.NRRD"), &read);
        assert_memory_equal(read.dims, written.dims, sizeof read.dims);
        assert_memory_equal(read.spacing, written.spacing, sizeof read.spacing);
        assert_memory_equal(read.origin, written.origin, sizeof read.origin);
        assert_int_equal(read.type, types[i]);
        assert_memory_equal(read.data, written.data, gp_volume_bytes(&written));
        gp_volume_free(&written);
        gp_volume_free(&read);
        assert_null(read.data);
    }
    assert_int_equal(folder_count(false), 1);
}

static void bits_come_back_as_bits_and_from_nrrd_as_bytes(void **state)
{
    (void)state;
    for (uint32_t side = 2; side <= 17; side++) {
        GpVolume bits = random_volume(GP_VOLUME_BITS, side, side, side), read;
        size_t samples = (size_t)side * side * side;
        assert_int_equal(gp_volume_write(in_folder("v.bits"), &bits, &error), GP_OK);
        read_well(in_folder("v.bits"), &read);
        assert_int_equal(read.type, GP_VOLUME_BITS);
        assert_memory_equal(read.dims, bits.dims, sizeof read.dims);
        assert_memory_equal(read.data, bits.data, (samples + 7) / 8);
        gp_volume_free(&read);

        assert_int_equal(gp_volume_write(in_folder("v.nrrd"), &bits, &error), GP_OK);
        read_well(in_folder("v.nrrd"), &read);
        assert_int_equal(read.type, GP_VOLUME_U8);
        const uint8_t *bytes = read.data, *data = bits.data;
        for (size_t i = 0; i < samples; i++)
            assert_int_equal(bytes[i], data[i / 8] >> i % 8 & 1);
        gp_volume_free(&read);
        gp_volume_free(&bits);
    }
}

/* Larger than what is packed and unpacked at once. */
static void large_volumes_come_back(void **state)
{
    (void)state;
    GpVolume written = random_volume(GP_VOLUME_U16, 128, 129, 65), read;
    assert_int_equal(gp_volume_write(in_folder("v.nrrd"), &written, &error), GP_OK);
    read_well(in_folder("v.nrrd"), &read);
    assert_memory_equal(read.data, written.data, gp_volume_bytes(&written));
    gp_volume_free(&written);
    gp_volume_free(&read);
}

static void only_cubes_of_bits_go_into_bits(void **state)
{
    (void)state;
    GpVolume bytes = random_volume(GP_VOLUME_U8, 4, 4, 4);
    GpVolume slab = random_volume(GP_VOLUME_BITS, 8, 8, 4);
    assert_int_equal(gp_volume_write(in_folder("v.bits"), &bytes, &error), GP_ERROR_INVALID);
    assert_int_equal(gp_volume_write(in_folder("v.bits"), &slab, &error), GP_ERROR_INVALID);
    assert_int_equal(gp_volume_write(in_folder("v.raw"), &bytes, &error), GP_ERROR_UNSUPPORTED);
    assert_int_equal(gp_volume_write(in_folder("no/v.nrrd"), &bytes, &error), GP_ERROR_IO);
    assert_int_equal(folder_count(false), 0);
    gp_volume_free(&bytes);
    gp_volume_free(&slab);
}

/* --- files of others -------------------------------------------------------------------------- */

#define HEADER(encoding)                                                                           \
    "NRRD0003\r\n# a comment\r\ntype: short\r\ndimension: 3\r\nsizes: 2 1 2\r\n"                   \
    "own key:=anything\r\nkinds: space space space\r\n" encoding "\r\n"

/* The samples 1, -2, 770, 4. */
static const unsigned char little[] = { 1, 0, 0xfe, 0xff, 2, 3, 4, 0 };
static const unsigned char big[] = { 0, 1, 0xff, 0xfe, 3, 2, 0, 4 };

static const char *put_both(const char *name, const char *header, const void *data, size_t size)
{
    char bytes[1024];
    size_t length = strlen(header);
    memcpy(bytes, header, length);
    memcpy(bytes + length, data, size);
    return put_file(name, bytes, length + size);
}

static void expect_samples(const char *path, const double spacing[3])
{
    static const int16_t samples[] = { 1, -2, 770, 4 };
    GpVolume volume;
    read_well(path, &volume);
    assert_int_equal(volume.type, GP_VOLUME_I16);
    assert_memory_equal(volume.dims, ((uint32_t[]){ 2, 1, 2 }), sizeof volume.dims);
    assert_memory_equal(volume.data, samples, sizeof samples);
    for (int k = 0; k < 3; k++)
        assert_true(volume.spacing[k] == spacing[k]);
    gp_volume_free(&volume);
}

/* Packs to gzip as other programs would. */
static size_t pack(const void *data, size_t size, unsigned char *out, size_t room)
{
    z_stream stream = { .next_in = NULL };
    assert_int_equal(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
    stream.next_in = (Bytef *)(uintptr_t)data;
    stream.avail_in = (uInt)size;
    stream.next_out = out;
    stream.avail_out = (uInt)room;
    assert_int_equal(deflate(&stream, Z_FINISH), Z_STREAM_END);
    deflateEnd(&stream);
    return stream.total_out;
}

static void both_byte_orders_and_encodings_are_read(void **state)
{
    (void)state;
    unsigned char packed[256];
    const double one[3] = { 1, 1, 1 }, some[3] = { 0.5, 1, 3 };
    const char *raw = HEADER("encoding: raw\r\nendian: big\r\n");
    expect_samples(put_both("a.nrrd", raw, big, sizeof big), one);
    raw = HEADER("encoding: raw \t\nendian: little\nbyte skip: 0\nspacings: 0.5 nan 3\n");
    expect_samples(put_both("b.nrrd", raw, little, sizeof little), some);
    size_t size = pack(big, sizeof big, packed, sizeof packed);
    const char *gzip = HEADER("encoding: gz\nendian: big\n"
                              "space directions: (0.3,0.4,0) (0, 1, 0) (0,0,-3)\n");
    expect_samples(put_both("c.nrrd", gzip, packed, size), some);
}

static void joined_gzip_files_are_one(void **state)
{
    (void)state;
    unsigned char packed[256];
    const double one[3] = { 1, 1, 1 };
    size_t size = pack(little, 3, packed, sizeof packed);
    size += pack(little + 3, sizeof little - 3, packed + size, sizeof packed - size);
    expect_samples(put_both("a.nrrd", HEADER("encoding: gzip\nendian: little\n"), packed, size),
                   one);
}

static void raw_samples_take_their_meaning_from_the_json_beside(void **state)
{
    (void)state;
    unsigned char packed[256];
    const double one[3] = { 1, 1, 1 }, some[3] = { 0.5, 1, 3 };
    put_text("a.json", "{ \"dims\": [2, 1, 2], \"type\": \"int16\" }");
    expect_samples(put_file("a.raw", little, sizeof little), one);
    put_text("b.json", "{ \"dims_xyz\": [2, 1, 2], \"type\": \"int16be\", \"order\": \"x fastest\","
                       " \"spacing_xyz\": [0.5, 1, 3], \"min\": -2 }");
    size_t size = pack(big, sizeof big, packed, sizeof packed);
    expect_samples(put_file("b.raw.gz", packed, size), some);
}

/* --- what is wrong ---------------------------------------------------------------------------- */

/* A file's text, and what is said of it. */
typedef struct Refusal {
    const char *text;
    GpResult result;
    const char *part;
} Refusal;

static void wrong_headers_are_refused_with_their_line(void **state)
{
    (void)state;
    static const Refusal cases[] = {
        { "", GP_ERROR_FORMAT, "byte 0: expected 'NRRD0001'" },
        { "NRRD", GP_ERROR_FORMAT, "byte 0" },
        { "NRRD0009\n\n", GP_ERROR_FORMAT, "byte 0" },
        { "P5 1 1 255\n.....", GP_ERROR_FORMAT, "byte 0" },
        { "NRRD0004\n", GP_ERROR_FORMAT, "expected an empty line" },
        { "NRRD0004\ntype: uint8", GP_ERROR_FORMAT, "line 2: the file ends" },
        { "NRRD0004\ntype: double\n\n", GP_ERROR_UNSUPPORTED, "line 2: expected the type uint8" },
        { "NRRD0004\nhello\n\n", GP_ERROR_FORMAT, "line 2: expected a line 'field: value'" },
        { "NRRD0004\ndimension: 4\n\n", GP_ERROR_UNSUPPORTED, "line 2: expected dimension 3" },
        { "NRRD0004\n#\nsizes: 1 2\n\n", GP_ERROR_FORMAT, "line 3: expected three sizes" },
        { "NRRD0004\nsizes: 1 2 3 4\n\n", GP_ERROR_FORMAT, "three sizes" },
        { "NRRD0004\nsizes: 1 0 3\n\n", GP_ERROR_FORMAT, "three sizes" },
        { "NRRD0004\nsizes: 1 -2 3\n\n", GP_ERROR_FORMAT, "three sizes" },
        { "NRRD0004\nsizes: 1 2x 3\n\n", GP_ERROR_FORMAT, "three sizes" },
        { "NRRD0004\nsizes: 65536 1 1\n\n", GP_ERROR_FORMAT, "three sizes" },
        { "NRRD0004\nsizes: 18446744073709551617 1 1\n\n", GP_ERROR_FORMAT, "three sizes" },
        { "NRRD0004\nencoding: bzip2\n\n", GP_ERROR_UNSUPPORTED, "the encoding raw or gzip" },
        { "NRRD0004\nendian: middle\n\n", GP_ERROR_FORMAT, "little or big" },
        { "NRRD0004\nspacings: 1 0 1\n\n", GP_ERROR_FORMAT, "three numbers above 0" },
        { "NRRD0004\nspacings: 1 1\n\n", GP_ERROR_FORMAT, "three numbers above 0" },
        { "NRRD0004\nspace directions: none (1,0,0) (0,1,0)\n\n", GP_ERROR_FORMAT, "vectors" },
        { "NRRD0004\nspace directions: (0,0,0) (1,0,0) (0,1,0)\n\n", GP_ERROR_FORMAT, "vectors" },
        { "NRRD0004\nspace origin: (0,0)\n\n", GP_ERROR_FORMAT,
          "line 2: expected a place (x,y,z)" },
        { "NRRD0004\nspace origin: (0,inf,0)\n\n", GP_ERROR_FORMAT, "a place (x,y,z)" },
        { "NRRD0004\nspace origin: (nan,0,0)\n\n", GP_ERROR_FORMAT, "a place (x,y,z)" },
        { "NRRD0004\nspace origin: (0,0,1\n\n", GP_ERROR_FORMAT, "a place (x,y,z)" },
        { "NRRD0004\ntype:\n\n", GP_ERROR_UNSUPPORTED, "line 2" },
        { "NRRD0000\ntype: uint8\n\n", GP_ERROR_FORMAT, "byte 0" },
        { "NRRD0004\nspace origin: (0,0,nan)\n\n", GP_ERROR_FORMAT, "a place (x,y,z)" },
        { "NRRD0004\nspace origin: (0,0,1) 2\n\n", GP_ERROR_FORMAT, "a place (x,y,z)" },
        { "NRRD0004\ndata file: v.raw\n\n", GP_ERROR_UNSUPPORTED, "the samples behind" },
        { "NRRD0004\nbyte skip: -1\n\n", GP_ERROR_UNSUPPORTED, "a skip of 0" },
        { "NRRD0004\ntype: uint8\ntype: uint8\n\n", GP_ERROR_FORMAT, "line 3: expected each" },
        { "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1 1 1\n\n", GP_ERROR_FORMAT,
          "expected the field 'encoding'" },
        { "NRRD0004\ntype: int16\ndimension: 3\nsizes: 1 1 1\nencoding: raw\n\n", GP_ERROR_FORMAT,
          "expected the field 'endian'" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        assert_refused(put_text("v.nrrd", cases[i].text), cases[i].result, cases[i].part);
}

static void samples_that_are_too_few_or_too_many_are_refused(void **state)
{
    (void)state;
    const char *raw = HEADER("encoding: raw\nendian: little\n");
    const char *gzip = HEADER("encoding: gzip\nendian: little\n");
    unsigned char packed[256], more[sizeof little + 2] = { 0 };
    assert_refused(put_both("v.nrrd", raw, little, 7), GP_ERROR_FORMAT, "7 bytes of samples");
    assert_refused(put_both("v.nrrd", raw, more, 9), GP_ERROR_FORMAT, "9 bytes of samples");
    size_t size = pack(little, 7, packed, sizeof packed);
    assert_refused(put_both("v.nrrd", gzip, packed, size), GP_ERROR_FORMAT,
                   "ends after 7 of 8 bytes");
    size = pack(more, 9, packed, sizeof packed);
    assert_refused(put_both("v.nrrd", gzip, packed, size), GP_ERROR_FORMAT, "more than 8 bytes");
    size = pack(little, 8, packed, sizeof packed);
    for (size_t cut = 0; cut < size; cut++)
        assert_refused(put_both("v.nrrd", gzip, packed, cut), GP_ERROR_FORMAT,
                       cut < size - 8 ? "byte " : "before the checksum of its gzip data");
    memcpy(packed + size, "PK", 2);
    assert_refused(put_both("v.nrrd", gzip, packed, size + 1), GP_ERROR_FORMAT, "no gzip data");
    assert_refused(put_both("v.nrrd", gzip, packed, size + 2), GP_ERROR_FORMAT, "header check");
    packed[size - 5] ^= 1; /* of the checksum */
    assert_refused(put_both("v.nrrd", gzip, packed, size), GP_ERROR_FORMAT, "data check");
    assert_refused(put_both("v.nrrd", gzip, "no gzip!", 8), GP_ERROR_FORMAT, "header check");
}

/* Refused before memory is asked for: the file is too short for any such volume. */
static void sizes_beyond_the_file_are_refused(void **state)
{
    (void)state;
    put_text("a.json", "{ \"dims\": [65535, 65535, 65535], \"type\": \"float\" }");
    assert_refused(put_text("a.raw", "short"), GP_ERROR_FORMAT, "65535 x 65535 x 65535");
    assert_refused(put_text("a.raw.gz", "short"), GP_ERROR_FORMAT, "65535 x 65535 x 65535");
    assert_refused(put_text("b.nrrd", "NRRD0004\ntype: float\ndimension: 3\n"
                                      "sizes: 65535 65535 65535\nencoding: gzip\nendian: big\n\n."),
                   GP_ERROR_FORMAT, "65535 x 65535 x 65535");
}

static void wrong_json_is_refused(void **state)
{
    (void)state;
    static const Refusal cases[] = {
        { "", GP_ERROR_FORMAT, "line 1" },
        { "{\n\"dims\": [1,\n", GP_ERROR_FORMAT, "line 3" },
        { "[1, 2]", GP_ERROR_FORMAT, "dims: expected three" },
        { "{ \"dims\": [1, 2], \"type\": \"uint8\" }", GP_ERROR_FORMAT, "dims: expected three" },
        { "{ \"dims\": [1, 2, 0], \"type\": \"uint8\" }", GP_ERROR_FORMAT, "dims: expected three" },
        { "{ \"dims\": [1, 2, 65536], \"type\": \"uint8\" }", GP_ERROR_FORMAT, "dims" },
        { "{ \"dims\": [1, 2, 2.5], \"type\": \"uint8\" }", GP_ERROR_FORMAT, "dims" },
        { "{ \"dims\": [1, 2, 4] }", GP_ERROR_FORMAT, "type: expected uint8" },
        { "{ \"dims\": [1, 2, 4], \"type\": \"double\" }", GP_ERROR_FORMAT, "not 'double'" },
        { "{ \"dims\": [1, 2, 4], \"type\": \"le\" }", GP_ERROR_FORMAT, "not 'le'" },
        { "{ \"dims\": [1, 2, 4], \"type\": \"uint8\", \"spacing\": [1, 1] }", GP_ERROR_FORMAT,
          "spacing: expected three" },
        { "{ \"dims\": [1, 2, 4], \"type\": \"uint8\", \"spacing\": [1, 1, -1] }", GP_ERROR_FORMAT,
          "spacing: expected three" },
        { "{ \"dims\": [1, 2, 4], \"type\": \"uint8\", \"order\": \"z fastest\" }",
          GP_ERROR_UNSUPPORTED, "order" },
    };
    put_text("v.raw", "samples!");
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        put_text("v.json", cases[i].text);
        assert_refused(in_folder("v.raw"), cases[i].result, cases[i].part);
        assert_non_null(strstr(error.text, "v.json"));
    }
    assert_refused(put_text("alone.raw", "samples!"), GP_ERROR_IO, "alone.json");
}

static void bits_that_are_no_cube_are_refused(void **state)
{
    (void)state;
    static const char zeros[513], ones[4] = { -1, -1, -1, -1 };
    assert_refused(put_file("v.bits", zeros, 0), GP_ERROR_FORMAT, "the bits of a cube");
    assert_refused(put_file("v.bits", zeros, 511), GP_ERROR_FORMAT, "512 bytes for 16 a side");
    assert_refused(put_file("v.bits", zeros, 513), GP_ERROR_FORMAT, "615 bytes for 17 a side");
    assert_refused(put_file("v.bits", ones, 4), GP_ERROR_FORMAT, "byte 3"); /* 27 bits of 32 */
    assert_refused(in_folder("none.bits"), GP_ERROR_IO, "none.bits");
    assert_refused(put_file("v.vol", zeros, 8), GP_ERROR_UNSUPPORTED, ".nrrd, .raw");
}

/* --- a real one ------------------------------------------------------------------------------- */

static void a_scanned_volume_has_its_known_range(void **state)
{
    (void)state;
    char path[400];
    GpVolume volume;
    if (gp_data_find("volumes/headsq_quarter.raw.gz", path, sizeof path, &error))
        skip();
    read_well(path, &volume);
    assert_int_equal(volume.type, GP_VOLUME_I16);
    assert_memory_equal(volume.dims, ((uint32_t[]){ 64, 64, 93 }), sizeof volume.dims);
    assert_true(volume.spacing[0] == 3.2 && volume.spacing[1] == 3.2 && volume.spacing[2] == 1.5);
    const int16_t *samples = volume.data;
    int16_t low = samples[0], high = samples[0];
    for (size_t i = 0; i < (size_t)64 * 64 * 93; i++) {
        low = samples[i] < low ? samples[i] : low;
        high = samples[i] > high ? samples[i] : high;
    }
    assert_int_equal(low, 0);
    assert_int_equal(high, 3926);
    gp_volume_free(&volume);
}

int main(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, folder_set_up, folder_tear_down)
    const struct CMUnitTest tests[] = {
        TEST(samples_of_every_type_come_back_from_nrrd),
        TEST(bits_come_back_as_bits_and_from_nrrd_as_bytes),
        TEST(large_volumes_come_back),
        TEST(only_cubes_of_bits_go_into_bits),
        TEST(both_byte_orders_and_encodings_are_read),
        TEST(joined_gzip_files_are_one),
        TEST(raw_samples_take_their_meaning_from_the_json_beside),
        TEST(wrong_headers_are_refused_with_their_line),
        TEST(samples_that_are_too_few_or_too_many_are_refused),
        TEST(sizes_beyond_the_file_are_refused),
        TEST(wrong_json_is_refused),
        TEST(bits_that_are_no_cube_are_refused),
        cmocka_unit_test(a_scanned_volume_has_its_known_range),
    };
    return cmocka_run_group_tests_name("volume", tests, NULL, NULL);
}
