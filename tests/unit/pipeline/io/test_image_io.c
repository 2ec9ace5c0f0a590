/* Pictures in files, and files as a whole: what comes back is what was written, bit for bit; known
 * bytes mean known pixels; damaged files, full disks and absurd sizes give errors and leave nothing
 * behind. */
#define _GNU_SOURCE /* memmem */
#include "pipeline/io/file.h"
#include "pipeline/io/image/image_file.h"
#include "tests/support/image_case.h"
#include "tests/support/random.h"

#include <errno.h>
#include <fenv.h>
#include <limits.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

/* A picture of random bits; floats are kept from being signalling NaNs only. */
static GpImage random_image(uint32_t width, uint32_t height, uint32_t channels, GpImageType type,
                            uint64_t number)
{
    Random seed = { number };
    GpImage image = { .width = width, .height = height, .channels = channels, .type = type };
    image.data = gp_alloc(image_bytes(&image), 1);
    assert_non_null(image.data);
    for (size_t i = 0; i < image_bytes(&image); i++)
        ((uint8_t *)image.data)[i] = (uint8_t)random_word(&seed);
    size_t samples = image_bytes(&image) / gp_image_sample_size(type);
    for (size_t i = 0; i < samples; i++) {
        if (type == GP_IMAGE_F32 && (((uint32_t *)image.data)[i] & 0x7f800000u) == 0x7f800000u)
            ((uint32_t *)image.data)[i] |= 0x00400000u;
        if (type == GP_IMAGE_F16 && (((uint16_t *)image.data)[i] & 0x7c00u) == 0x7c00u)
            ((uint16_t *)image.data)[i] |= 0x0200u;
    }
    return image;
}

static void assert_same_image(const GpImage *a, const GpImage *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_int_equal(a->channels, b->channels);
    assert_int_equal(a->type, b->type);
    assert_memory_equal(a->data, b->data, image_bytes(a));
}

/* --- round trips ------------------------------------------------------------------------------ */

static const struct {
    const char *name;
    GpImageType type;
    uint32_t channels;
} writable[] = {
    { "a.png", GP_IMAGE_U8, 1 },  { "a.png", GP_IMAGE_U8, 2 },  { "a.png", GP_IMAGE_U8, 3 },
    { "a.png", GP_IMAGE_U8, 4 },  { "a.png", GP_IMAGE_U16, 1 }, { "a.png", GP_IMAGE_U16, 2 },
    { "a.png", GP_IMAGE_U16, 3 }, { "a.png", GP_IMAGE_U16, 4 }, { "a.exr", GP_IMAGE_F16, 1 },
    { "a.exr", GP_IMAGE_F16, 3 }, { "a.exr", GP_IMAGE_F16, 4 }, { "a.exr", GP_IMAGE_F32, 1 },
    { "a.exr", GP_IMAGE_F32, 2 }, { "a.exr", GP_IMAGE_F32, 3 }, { "a.exr", GP_IMAGE_F32, 4 },
    { "a.pfm", GP_IMAGE_F32, 1 }, { "a.pfm", GP_IMAGE_F32, 3 }, { "a.ppm", GP_IMAGE_U8, 3 },
    { "a.PPM", GP_IMAGE_U16, 3 }, { "a.pgm", GP_IMAGE_U8, 1 },  { "a.pgm", GP_IMAGE_U16, 1 },
};

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
            if (gp_image_write(path, &image, &error) != GP_OK)
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
        assert_int_equal(gp_image_write(in_folder(writable[i].name), &image, &error), GP_OK);
        assert_int_equal(gp_image_write(in_folder(other), &image, &error), GP_OK);
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
    assert_int_equal(gp_image_write(in_folder("a.png"), &image, &error), GP_OK);
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
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, &error), GP_OK);
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

/* --- bad files --------------------------------------------------------------------------------- */

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
            assert_int_equal(gp_image_write(in_folder(writable[j].name), &image, &error), GP_OK);
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

/* Overwrites the data window of an EXR file. */
static void exr_windows_are_checked(void **state)
{
    (void)state;
    GpImage image = random_image(4, 4, 3, GP_IMAGE_F16, 1);
    GpFile file;
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, &error), GP_OK);
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
        assert_int_equal(gp_image_write(in_folder(names[count]), &image, &error), GP_OK);
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

/* --- writing where it fails --------------------------------------------------------------------- */

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
        assert_int_equal(gp_image_write(in_folder(cases[i].name), &image, &error), cases[i].result);
        assert_true(error.text[0] != '\0');
    }
    assert_int_equal(folder_count(false), 0);
}

static void an_unwritable_place_is_an_error_and_stays_clean(void **state)
{
    (void)state;
    GpImage image = random_image(5, 5, 3, GP_IMAGE_U8, 1);
    put_file("file", "x", 1);
    assert_int_equal(gp_image_write(in_folder("file/a.png"), &image, &error), GP_ERROR_IO);
    assert_int_equal(gp_image_write(in_folder("none/a.png"), &image, &error), GP_ERROR_IO);
    assert_int_equal(mkdir(in_folder("folder.png"), 0777), 0);
    assert_int_equal(gp_image_write(in_folder("folder.png"), &image, &error), GP_ERROR_IO);
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
    assert_int_equal(gp_image_write(in_folder("a.exr"), &image, &error), GP_ERROR_IO);
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
            _exit(gp_image_write(in_folder(names[i]), &image, NULL) == GP_ERROR_IO ? 0 : 1);
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

/* --- files --------------------------------------------------------------------------------------- */

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
    }
}

static void rounding_mode_survives_reading_and_writing(void **state)
{
    (void)state;
    GpImage image = random_image(9, 9, 4, GP_IMAGE_F32, 1), back;
    fesetround(FE_UPWARD);
    GpResult written = gp_image_write(in_folder("a.exr"), &image, &error);
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

/* --- the shared pictures ------------------------------------------------------------------------- */

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(every_written_format_reads_back_bit_for_bit),
        TEST(the_same_picture_gives_the_same_bytes_under_any_name),
        TEST(png_holds_no_text_and_no_time),
        TEST(exr_holds_no_text),
        TEST(unreadable_paths_are_told_apart),
        TEST(a_file_under_another_formats_name_is_refused),
        TEST(absurd_sizes_are_refused_before_any_allocation),
        TEST(exr_windows_are_checked),
        TEST(every_truncation_is_an_error),
        TEST(damaged_bytes_give_a_picture_or_an_error),
        TEST(what_a_format_cannot_hold_is_not_written),
        TEST(an_unwritable_place_is_an_error_and_stays_clean),
        TEST(a_full_device_is_an_error),
        TEST(a_full_disk_leaves_the_old_file),
        TEST(a_file_is_replaced_at_once_and_links_are_followed),
        TEST(new_files_obey_the_umask),
        TEST(data_is_found_here_first_then_in_the_variable),
        TEST(extensions_are_the_last_and_lower_case),
        TEST(rounding_mode_survives_reading_and_writing),
        TEST(shared_pictures_hold_the_files_own_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
