/* Pictures in files, and files as a whole: what comes back is what was written, bit for bit; known
 * bytes mean known pixels; a file is replaced as a whole. */
#define _GNU_SOURCE /* memmem */
#include "pipeline/io/file.h"
#include "tests/support/image_case.h"

#include <errno.h>
#include <fenv.h>
#include <limits.h>
#include <signal.h>

static void assert_same_image(const GpImage *a, const GpImage *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_int_equal(a->channels, b->channels);
    assert_int_equal(a->type, b->type);
    assert_memory_equal(a->data, b->data, image_bytes(a));
}

/* --- round trips ------------------------------------------------------------------------------ */

static void every_written_format_reads_back_bit_for_bit(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = { { 1, 1 }, { 7, 5 }, { 1, 300 }, { 131, 2 }, { 64, 64 } };
    for (size_t i = 0; i < GP_COUNT(writable); i++) {
        for (size_t s = 0; s < GP_COUNT(sizes); s++) {
            GpImage image = random_image(sizes[s][0], sizes[s][1], writable[i].channels,
                                         writable[i].type, 100 * i + s);
            GpImage back;
            const char *path = in_folder(writable[i].name);
            if (gp_image_write(path, &image, NULL, &error) != GP_OK)
                fail_msg("%s", error.text);
            assert_reads(path, &back);
            assert_same_image(&image, &back);
            assert_int_equal(folder_count(true), 1);
            gp_image_free(&image);
            gp_image_free(&back);
            assert_null(back.data);
        }
    }
}

static void the_same_picture_gives_the_same_bytes_under_any_name(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(writable); i++) {
        GpImage image = random_image(33, 9, writable[i].channels, writable[i].type, i);
        char other[32];
        snprintf(other, sizeof other, "other%s", writable[i].name + 1);
        GpFile a, b;
        assert_int_equal(gp_image_write(in_folder(writable[i].name), &image, NULL, &error), GP_OK);
        assert_int_equal(gp_image_write(in_folder(other), &image, NULL, &error), GP_OK);
        assert_int_equal(gp_file_read(in_folder(writable[i].name), &a, &error), GP_OK);
        assert_int_equal(gp_file_read(in_folder(other), &b, &error), GP_OK);
        assert_int_equal(a.size, b.size);
        assert_memory_equal(a.data, b.data, a.size);
        gp_file_free(&a);
        gp_file_free(&b);
        gp_image_free(&image);
    }
}

/* Bytes cannot depend on the day where no chunk or attribute can hold one; oFFs is an offset. */
static void png_holds_no_text_and_no_time(void **state)
{
    (void)state;
    GpImage image = random_image(20, 10, 4, GP_IMAGE_U8, 1);
    GpFile file;
    assert_int_equal(gp_image_write(in_folder("a.png"), &image, NULL, &error), GP_OK);
    assert_int_equal(gp_file_read(in_folder("a.png"), &file, &error), GP_OK);
    size_t chunks = 0;
    for (size_t at = 8; at < file.size; chunks++) {
        const unsigned char *chunk = (const unsigned char *)file.data + at;
        assert_true(memcmp(chunk + 4, "IHDR", 4) == 0 || memcmp(chunk + 4, "IDAT", 4) == 0 ||
                    memcmp(chunk + 4, "IEND", 4) == 0 || memcmp(chunk + 4, "oFFs", 4) == 0);
        at += 12 +
              ((size_t)chunk[0] << 24 | (size_t)chunk[1] << 16 | (size_t)chunk[2] << 8 | chunk[3]);
    }
    assert_true(chunks >= 3);
    gp_file_free(&file);
    gp_image_free(&image);
}

static void exr_holds_no_text(void **state)
{
    (void)state;
    GpImage image = random_image(4, 4, 3, GP_IMAGE_F32, 1);
    GpFile file;
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, NULL, &error), GP_OK);
    assert_int_equal(gp_file_read(in_folder("a.exr"), &file, &error), GP_OK);
    for (size_t at = 8; file.data[at] != '\0';) {
        const char *name = file.data + at, *type = name + strlen(name) + 1;
        const unsigned char *size = (const unsigned char *)type + strlen(type) + 1;
        size_t length = size[0] | (size_t)size[1] << 8 | (size_t)size[2] << 16;
        if (strcmp(type, "string") == 0 && length > 0)
            fail_msg("attribute %s", name);
        at = (size_t)((const char *)size - file.data) + 4 + length;
    }
    gp_file_free(&file);
    gp_image_free(&image);
}

/* --- files ------------------------------------------------------------------------------------ */

static void a_file_is_replaced_at_once_and_links_are_followed(void **state)
{
    (void)state;
    GpFile file;
    assert_int_equal(gp_file_write(in_folder("a"), "first", 5, &error), GP_OK);
    assert_int_equal(symlink("a", in_folder("link")), 0);
    FILE *old = fopen(in_folder("a"), "rb");
    assert_non_null(old);
    assert_int_equal(gp_file_write(in_folder("link"), "second one", 10, &error), GP_OK);
    char text[16] = "";
    assert_int_equal(fread(text, 1, sizeof text, old), 5); /* whoever reads, reads the old one */
    fclose(old);
    assert_string_equal(text, "first");
    assert_int_equal(gp_file_read(in_folder("a"), &file, &error), GP_OK);
    assert_string_equal(file.data, "second one");
    gp_file_free(&file);
    assert_int_equal(gp_file_write(in_folder("empty"), NULL, 0, &error), GP_OK);
    assert_int_equal(gp_file_read(in_folder("empty"), &file, &error), GP_OK);
    assert_int_equal(file.size, 0);
    gp_file_free(&file);
    assert_int_equal(folder_count(false), 3);
}

static void new_files_obey_the_umask(void **state)
{
    (void)state;
    mode_t old = umask(027);
    assert_int_equal(gp_file_write(in_folder("a"), "x", 1, &error), GP_OK);
    umask(old);
    struct stat info;
    assert_int_equal(stat(in_folder("a"), &info), 0);
    assert_int_equal(info.st_mode & 0777, 0640);
}

static void data_is_found_here_first_then_in_the_variable(void **state)
{
    (void)state;
    const char *variable = getenv("GLASSPIPE_DATA");
    char *saved = variable ? strdup(variable) : NULL;
    char path[PATH_MAX] = "untouched", small[4] = "abc";
    put_file("only-here.txt", "x", 1);
    setenv("GLASSPIPE_DATA", folder, 1);
    assert_int_equal(gp_data_find("only-here.txt", path, sizeof path, &error), GP_OK);
    assert_string_equal(path, in_folder("only-here.txt"));
    assert_int_equal(gp_data_find("only-here.txt", small, sizeof small, &error), GP_ERROR_IO);
    assert_string_equal(small, "abc");
    assert_int_equal(gp_data_find(in_folder("only-here.txt"), path, sizeof path, &error), GP_OK);
    strcpy(path, "untouched");
    assert_int_equal(gp_data_find("not/there.txt", path, sizeof path, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, folder));
    assert_string_equal(path, "untouched");
    unsetenv("GLASSPIPE_DATA");
    assert_int_equal(gp_data_find("only-here.txt", path, sizeof path, &error), GP_ERROR_IO);

    char here[PATH_MAX];
    assert_non_null(getcwd(here, sizeof here));
    assert_int_equal(chdir(folder), 0);
    setenv("GLASSPIPE_DATA", "/", 1);
    assert_int_equal(gp_data_find("only-here.txt", path, sizeof path, &error), GP_OK);
    assert_string_equal(path, "only-here.txt");
    assert_int_equal(chdir(here), 0);
    if (saved)
        setenv("GLASSPIPE_DATA", saved, 1);
    else
        unsetenv("GLASSPIPE_DATA");
    free(saved);
}

static void extensions_are_the_last_and_lower_case(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        { "a.PNG", "png" },     { "a.b.Om", "om" }, { "a", "" },
        { "a.b/c", "" },        { "a.", "" },       { "a.longextension", "" },
        { "/x.y/z.ply", "ply" }
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        char extension[8];
        gp_file_extension(cases[i][0], extension);
        assert_string_equal(extension, cases[i][1]);
        assert_true(gp_file_has_extension(cases[i][0], cases[i][1]));
        assert_false(gp_file_has_extension(cases[i][0], "pn"));
    }
}

static void rounding_mode_survives_reading_and_writing(void **state)
{
    (void)state;
    GpImage image = random_image(9, 9, 4, GP_IMAGE_F32, 1), back;
    fesetround(FE_UPWARD);
    GpResult written = gp_image_write(in_folder("a.exr"), &image, NULL, &error);
    int after_write = fegetround();
    GpResult read = gp_image_read(in_folder("a.exr"), &back, &error);
    int after_read = fegetround();
    fesetround(FE_TONEAREST);
    assert_int_equal(written, GP_OK);
    assert_int_equal(read, GP_OK);
    assert_int_equal(after_write, FE_UPWARD);
    assert_int_equal(after_read, FE_UPWARD);
    gp_image_free(&image);
    gp_image_free(&back);
}

/* --- the shared pictures ---------------------------------------------------------------------- */

/* Their bodies are plain enough to be read here in a few lines. */
static void shared_pictures_hold_the_files_own_bytes(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint32_t width, height, channels;
        GpImageType type;
    } cases[] = {
        { "images/pom_stones_color.ppm", 512, 512, 3, GP_IMAGE_U8 },
        { "images/livingroom_00_depth.pgm", 640, 480, 1, GP_IMAGE_U16 },
        { "images/pom_four_normal_height.tga", 256, 256, 4, GP_IMAGE_U8 },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        char path[PATH_MAX];
        if (gp_data_find(cases[i].name, path, sizeof path, NULL) != GP_OK)
            skip();
        GpImage image;
        GpFile file;
        assert_reads(path, &image);
        assert_int_equal(gp_file_read(path, &file, &error), GP_OK);
        assert_int_equal(image.width, cases[i].width);
        assert_int_equal(image.height, cases[i].height);
        assert_int_equal(image.channels, cases[i].channels);
        assert_int_equal(image.type, cases[i].type);
        const uint8_t *bytes = (const uint8_t *)file.data, *samples = image.data;
        bool is_tga = strstr(path, ".tga") != NULL;
        size_t size = image_bytes(&image), first = is_tga ? 18u + bytes[0] : file.size - size;
        size_t row = size / image.height;
        bool from_top = !is_tga || (bytes[17] & 0x20);
        for (size_t k = 0; k < size; k++) {
            size_t y = k / row, x = k % row;
            size_t swizzle = is_tga                       ? x - x % 4 + (x % 4 == 3 ? 3 : 2 - x % 4)
                             : image.type == GP_IMAGE_U16 ? x ^ 1
                                                          : x;
            size_t at = first + (from_top ? y : image.height - 1 - y) * row + swizzle;
            if (samples[k] != bytes[at])
                fail_msg("%s: byte %zu of the samples", path, k);
        }
        gp_file_free(&file);
        gp_image_free(&image);
    }
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(every_written_format_reads_back_bit_for_bit),
        TEST(the_same_picture_gives_the_same_bytes_under_any_name),
        TEST(png_holds_no_text_and_no_time),
        TEST(exr_holds_no_text),
        TEST(a_file_is_replaced_at_once_and_links_are_followed),
        TEST(new_files_obey_the_umask),
        TEST(data_is_found_here_first_then_in_the_variable),
        TEST(extensions_are_the_last_and_lower_case),
        TEST(rounding_mode_survives_reading_and_writing),
        TEST(shared_pictures_hold_the_files_own_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
