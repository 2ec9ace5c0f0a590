/* Pictures that cannot be read or written: damaged files, absurd sizes, full disks give errors and
 * leave nothing behind. */
#define _GNU_SOURCE
#include "pipeline/io/file.h"
#include "tests/support/image_case.h"
#include "tests/support/limited.h"

#include <errno.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

/* --- bad files -------------------------------------------------------------------------------- */

static void assert_refused(const char *path, GpResult expected, const char *part)
{
    GpImage image = { .width = 77 };
    error.text[0] = '\0';
    GpResult result = gp_image_read(path, &image, &error);
    if (result != expected || !strstr(error.text, part) || !strstr(error.text, path))
        fail_msg("%s: got %s, '%s'", path, gp_result_name(result), error.text);
    assert_int_equal(image.width, 77);
}

static void unreadable_paths_are_told_apart(void **state)
{
    (void)state;
    assert_refused(in_folder("none.png"), GP_ERROR_IO, "No such file");
    assert_refused(in_folder("none"), GP_ERROR_UNSUPPORTED, ".png");
    assert_refused(put_file("a.jpg", "x", 1), GP_ERROR_UNSUPPORTED, ".png");
    assert_refused(put_file("a.exr", "", 0), GP_ERROR_FORMAT, "empty");
    assert_int_equal(mkdir(in_folder("folder.png"), 0777), 0);
    assert_refused(in_folder("folder.png"), GP_ERROR_IO, "folder");
    assert_int_equal(mkfifo(in_folder("pipe.png"), 0600), 0);
    assert_refused(in_folder("pipe.png"), GP_ERROR_IO, "regular");
}

static void a_file_under_another_formats_name_is_refused(void **state)
{
    (void)state;
    static const char *const extensions[] = { "png", "exr", "pfm", "ppm", "pgm", "tga" };
    for (size_t i = 0; i < GP_COUNT(extensions); i++) {
        for (size_t j = 0; j < GP_COUNT(writable); j++) {
            char name[16], *extension = strchr(writable[j].name, '.') + 1;
            if (strcasecmp(extension, extensions[i]) == 0)
                continue;
            GpImage image = random_image(8, 8, writable[j].channels, writable[j].type, 3), back;
            assert_int_equal(gp_image_write(in_folder(writable[j].name), &image, NULL, &error),
                             GP_OK);
            snprintf(name, sizeof name, "b.%s", extensions[i]);
            assert_int_equal(rename(in_folder(writable[j].name), in_folder(name)), 0);
            GpResult result = gp_image_read(in_folder(name), &back, &error);
            assert_true(result == GP_ERROR_FORMAT || result == GP_ERROR_UNSUPPORTED);
            gp_image_free(&image);
        }
    }
}

static void absurd_sizes_are_refused_before_any_allocation(void **state)
{
    (void)state;
    static const char *const text[][2] = {
        { "a.ppm", "P6\n1000000 1000000\n255\n" }, { "a.ppm", "P6\n65537 1\n255\nabc" },
        { "a.pgm", "P5\n65536 65536\n65535\n" },   { "a.pfm", "PF\n1000000 1000000\n-1\n" },
        { "a.pfm", "Pf\n60000 60000\n-1.0\n" },    { "a.ppm", "P6\n99999999999 1\n255\n" },
        { "a.ppm", "P6\n60000 3000\n255\nabc" },
    };
    for (size_t i = 0; i < GP_COUNT(text); i++)
        assert_refused(put_file(text[i][0], text[i][1], strlen(text[i][1])),
                       strstr(text[i][1], "99999999999") || strstr(text[i][1], "3000\n")
                           ? GP_ERROR_FORMAT
                           : GP_ERROR_UNSUPPORTED,
                       "");
    static const char *const empty[][2] = { { "a.ppm", "P6\n0 1\n255\n" },
                                            { "a.pgm", "P5\n1 0\n255\n" },
                                            { "a.pfm", "PF\n0 0\n-1\n" } };
    for (size_t i = 0; i < GP_COUNT(empty); i++)
        assert_refused(put_file(empty[i][0], empty[i][1], strlen(empty[i][1])), GP_ERROR_FORMAT,
                       "x");

    unsigned char png[sizeof tiny_png];
    memcpy(png, tiny_png, sizeof png);
    memcpy(png + 16, "\0\x0f\x42\x40\0\x0f\x42\x40", 8);
    assert_refused(put_file("a.png", png, sizeof png), GP_ERROR_UNSUPPORTED, "1000000x1000000");
    memcpy(png + 16, "\0\0\x75\x30\0\0\x75\x30", 8); /* 30000: deflate cannot do that */
    assert_refused(put_file("a.png", png, sizeof png), GP_ERROR_FORMAT, "need");
    memcpy(png + 16, "\0\0\0\0\0\0\0\1", 8);
    assert_refused(put_file("a.png", png, sizeof png), GP_ERROR_FORMAT, "0x1");
    const unsigned char tga[18] = { 0, 0, 2, [12] = 0, 16, 0, 16, 24 };
    assert_refused(put_file("a.tga", tga, sizeof tga), GP_ERROR_FORMAT, "need");
}

/* The value of an attribute of an EXR file. */
static char *exr_value(const GpFile *file, const char *name, const char *type)
{
    const size_t length = strlen(name) + 1;
    char *at = memmem(file->data, file->size, name, length);
    assert_non_null(at);
    assert_string_equal(at + length, type);
    return at + length + strlen(type) + 1 + 4;
}

/* DWA packs so well that a file of 4 KB may hold 80 million pixels; this one does not. */
static void what_an_exr_promises_takes_no_memory(void **state)
{
    (void)state;
    if (!limits_hold())
        skip();
    static const int32_t window[4] = { 0, 0, 7999, 9999 };
    char bytes[4096] = { 0 };
    GpImage image = random_image(8, 8, 4, GP_IMAGE_F32, 1);
    GpFile file;
    struct rusage before, after;
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, NULL, &error), GP_OK);
    assert_refused(put_file("b.exr", "x", 1), GP_ERROR_FORMAT, "b.exr");
    assert_int_equal(gp_file_read(in_folder("a.exr"), &file, &error), GP_OK);
    memcpy(exr_value(&file, "dataWindow", "box2i"), window, sizeof window);
    *exr_value(&file, "compression", "compression") = 9;
    assert_true(file.size <= sizeof bytes);
    memcpy(bytes, file.data, file.size);
    getrusage(RUSAGE_SELF, &before);
    assert_refused(put_file("b.exr", bytes, sizeof bytes), GP_ERROR_FORMAT, "b.exr");
    getrusage(RUSAGE_SELF, &after);
    assert_true(after.ru_maxrss - before.ru_maxrss < 300 << 10);
    gp_file_free(&file);
    gp_image_free(&image);
}

/* Of samples that are of no known type, and of two lists joined, OpenImageIO ends the program. */
static void exr_channels_are_checked(void **state)
{
    (void)state;
    static const int32_t types[] = { 3, 256, -1 };
    GpImage image = random_image(4, 4, 3, GP_IMAGE_F16, 1);
    GpFile file;
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, NULL, &error), GP_OK);
    assert_int_equal(gp_file_read(in_folder("a.exr"), &file, &error), GP_OK);
    char *list = exr_value(&file, "channels", "chlist");
    const size_t before = sizeof "channels\0chlist" + 4;
    int32_t size;
    memcpy(&size, list - 4, 4);
    char twice[4096];
    const size_t attribute = before + (size_t)size;
    assert_true(file.size + attribute <= sizeof twice);
    memcpy(twice, file.data, 8);
    memcpy(twice + 8, list - before, attribute);
    memcpy(twice + 8 + attribute, file.data + 8, file.size - 8);
    assert_refused(put_file("b.exr", twice, file.size + attribute), GP_ERROR_FORMAT,
                   "one list of channels");
    for (size_t i = 0; i < GP_COUNT(types); i++) {
        memcpy(list + 2, &types[i], 4);
        assert_refused(put_file("b.exr", file.data, file.size), GP_ERROR_FORMAT,
                       "one list of channels");
    }
    gp_file_free(&file);
    gp_image_free(&image);
}

/* Overwrites the data window of an EXR file. */
static void exr_windows_are_checked(void **state)
{
    (void)state;
    GpImage image = random_image(4, 4, 3, GP_IMAGE_F16, 1);
    GpFile file;
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, NULL, &error), GP_OK);
    assert_int_equal(gp_file_read(in_folder("a.exr"), &file, &error), GP_OK);
    char *window = memmem(file.data, file.size, "dataWindow\0box2i\0\x10\0\0", 20);
    assert_non_null(window);
    static const struct {
        int32_t x1, y1;
        GpResult result;
    } cases[] = {
        { 999999, 999999, GP_ERROR_UNSUPPORTED },
        { -1, 3, GP_ERROR_FORMAT },
        { 3, 60000, GP_ERROR_FORMAT },
        { 2147483647, 3, GP_ERROR_UNSUPPORTED },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        int32_t box[4] = { 0, 0, cases[i].x1, cases[i].y1 };
        memcpy(window + 21, box, 16);
        assert_refused(put_file("b.exr", file.data, file.size), cases[i].result, "b.exr");
    }
    gp_file_free(&file);
    gp_image_free(&image);
}

/* Two small valid files of each kind. */
static size_t make_samples(GpFile samples[24], const char *names[24])
{
    static const uint8_t chosen[] = { 0, 7, 9, 14, 15, 16, 17, 18, 19, 20 }; /* of writable */
    size_t count = 0;
    for (size_t i = 0; i < GP_COUNT(chosen); i++, count++) {
        size_t kind = chosen[i];
        GpImage image = random_image(9, 6, writable[kind].channels, writable[kind].type, i);
        names[count] = writable[kind].name;
        assert_int_equal(gp_image_write(in_folder(names[count]), &image, NULL, &error), GP_OK);
        assert_int_equal(gp_file_read(in_folder(names[count]), &samples[count], &error), GP_OK);
        gp_image_free(&image);
    }
    for (unsigned char type = 2; type <= 10; type = (unsigned char)(type + 8)) {
        unsigned char tga[18 + 64] = { 0, 0, type, [12] = 4, [14] = 4, [16] = 32, [17] = 8 };
        size_t size = type == 2 ? sizeof tga : 18 + 5;
        if (type == 10)
            tga[18] = 0x8f; /* one packet of 16 pixels */
        names[count] = "a.tga";
        samples[count].data = gp_alloc(size, 1);
        memcpy(samples[count].data, tga, size);
        samples[count++].size = size;
    }
    return count;
}

static void every_truncation_is_an_error(void **state)
{
    (void)state;
    GpFile samples[24];
    const char *names[24];
    size_t count = make_samples(samples, names);
    for (size_t i = 0; i < count; i++) {
        GpImage image;
        assert_reads(put_file(names[i], samples[i].data, samples[i].size), &image);
        gp_image_free(&image);
        const char *path = put_file(names[i], samples[i].data, samples[i].size);
        for (size_t size = samples[i].size; size-- > 0;) {
            assert_int_equal(truncate(path, (off_t)size), 0);
            GpResult result = gp_image_read(path, &image, &error);
            if (result != GP_ERROR_FORMAT && result != GP_ERROR_UNSUPPORTED)
                fail_msg("%s cut to %zu of %zu bytes: %s", names[i], size, samples[i].size,
                         gp_result_name(result));
        }
        gp_file_free(&samples[i]);
    }
}

/* Writes one byte of an open file, in place. */
static void poke(FILE *file, size_t at, char byte)
{
    assert_int_equal(pwrite(fileno(file), &byte, 1, (off_t)at), 1);
}

static void damaged_bytes_give_a_picture_or_an_error(void **state)
{
    (void)state;
    GpFile samples[24];
    const char *names[24];
    size_t count = make_samples(samples, names);
    Random seed = { 2005 };
    unsigned refused = 0, read = 0;
    for (size_t i = 0; i < count; i++) {
        const GpFile *file = &samples[i];
        const char *path = put_file(names[i], file->data, file->size);
        FILE *open_file = fopen(path, "r+b");
        assert_non_null(open_file);
        for (int round = 0; round < 1000; round++) {
            uint32_t changes = 1 + random_word(&seed) % 3;
            size_t at[3];
            for (uint32_t c = 0; c < changes; c++) {
                /* Half of the changes hit the header. */
                size_t range = random_word(&seed) % 2 || file->size < 400 ? file->size : 400;
                at[c] = random_word(&seed) % range;
                poke(open_file, at[c], (char)random_word(&seed));
            }
            GpImage image;
            GpResult result = gp_image_read(path, &image, &error);
            if (result == GP_OK) {
                read++;
                assert_true(image.width >= 1 && image.height >= 1 && image.channels <= 4);
                gp_image_free(&image);
            } else {
                refused++;
                assert_true(result == GP_ERROR_FORMAT || result == GP_ERROR_UNSUPPORTED);
            }
            for (uint32_t c = 0; c < changes; c++)
                poke(open_file, at[c], file->data[at[c]]);
        }
        fclose(open_file);
        gp_file_free(&samples[i]);
    }
    assert_true(refused > 1000 && read > 1000);
}

/* --- writing where it fails ------------------------------------------------------------------- */

static void what_a_format_cannot_hold_is_not_written(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        GpImageType type;
        uint32_t channels, width;
        GpResult result;
    } cases[] = {
        { "a.png", GP_IMAGE_F32, 3, 2, GP_ERROR_INVALID },
        { "a.exr", GP_IMAGE_U8, 3, 2, GP_ERROR_INVALID },
        { "a.pfm", GP_IMAGE_F32, 4, 2, GP_ERROR_INVALID },
        { "a.pfm", GP_IMAGE_F16, 3, 2, GP_ERROR_INVALID },
        { "a.ppm", GP_IMAGE_U8, 4, 2, GP_ERROR_INVALID },
        { "a.pgm", GP_IMAGE_U8, 3, 2, GP_ERROR_INVALID },
        { "a.png", GP_IMAGE_U8, 0, 2, GP_ERROR_INVALID },
        { "a.png", GP_IMAGE_U8, 5, 2, GP_ERROR_INVALID },
        { "a.png", GP_IMAGE_U8, 3, 0, GP_ERROR_INVALID },
        { "a.png", GP_IMAGE_U8, 3, 65537, GP_ERROR_INVALID },
        { "a.tga", GP_IMAGE_U8, 3, 2, GP_ERROR_UNSUPPORTED },
        { "a", GP_IMAGE_U8, 3, 2, GP_ERROR_UNSUPPORTED },
    };
    float samples[64] = { 0 };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        GpImage image = { .width = cases[i].width,
                          .height = 2,
                          .channels = cases[i].channels,
                          .type = cases[i].type,
                          .data = samples };
        error.text[0] = '\0';
        assert_int_equal(gp_image_write(in_folder(cases[i].name), &image, NULL, &error),
                         cases[i].result);
        assert_true(error.text[0] != '\0');
    }
    assert_int_equal(folder_count(false), 0);
}

static void an_unwritable_place_is_an_error_and_stays_clean(void **state)
{
    (void)state;
    GpImage image = random_image(5, 5, 3, GP_IMAGE_U8, 1);
    put_file("file", "x", 1);
    assert_int_equal(gp_image_write(in_folder("file/a.png"), &image, NULL, &error), GP_ERROR_IO);
    assert_int_equal(gp_image_write(in_folder("none/a.png"), &image, NULL, &error), GP_ERROR_IO);
    assert_int_equal(mkdir(in_folder("folder.png"), 0777), 0);
    assert_int_equal(gp_image_write(in_folder("folder.png"), &image, NULL, &error), GP_ERROR_IO);
    assert_int_equal(folder_count(false), 2);
    gp_image_free(&image);
}

static void a_full_device_is_an_error(void **state)
{
    (void)state;
    if (access("/dev/full", W_OK) != 0)
        skip();
    GpImage image = random_image(5, 5, 3, GP_IMAGE_F32, 1);
    assert_int_equal(symlink("/dev/full", in_folder("a.exr")), 0);
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, NULL, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, strerror(ENOSPC)));
    struct stat info;
    assert_int_equal(stat("/dev/full", &info), 0);
    assert_true(S_ISCHR(info.st_mode)); /* still the device */
    gp_image_free(&image);
}

/* The child may not write files over 1000 bytes; the old file must survive it whole. */
static void a_full_disk_leaves_the_old_file(void **state)
{
    (void)state;
    GpImage image = random_image(64, 64, 3, GP_IMAGE_U8, 1);
    static const char *const names[] = { "a.png", "a.ppm" };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        put_file(names[i], "old", 3);
        pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            struct rlimit limit = { .rlim_cur = 1000, .rlim_max = 1000 };
            signal(SIGXFSZ, SIG_IGN);
            setrlimit(RLIMIT_FSIZE, &limit);
            _exit(gp_image_write(in_folder(names[i]), &image, NULL, NULL) == GP_ERROR_IO ? 0 : 1);
        }
        int status;
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_int_equal(status, 0);
        GpFile file;
        assert_int_equal(gp_file_read(in_folder(names[i]), &file, &error), GP_OK);
        assert_string_equal(file.data, "old");
        gp_file_free(&file);
        assert_int_equal(folder_count(false), (int)i + 1);
    }
    gp_image_free(&image);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(unreadable_paths_are_told_apart),
        TEST(a_file_under_another_formats_name_is_refused),
        TEST(absurd_sizes_are_refused_before_any_allocation),
        TEST(what_an_exr_promises_takes_no_memory),
        TEST(exr_windows_are_checked),
        TEST(exr_channels_are_checked),
        TEST(every_truncation_is_an_error),
        TEST(damaged_bytes_give_a_picture_or_an_error),
        TEST(what_a_format_cannot_hold_is_not_written),
        TEST(an_unwritable_place_is_an_error_and_stays_clean),
        TEST(a_full_device_is_an_error),
        TEST(a_full_disk_leaves_the_old_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
