/* PNG files written row by row: the same picture as at once, and the old file where it is not
 * whole. */
#include "pipeline/io/image/image_file.h"
#include "pipeline/io/image/png_rows.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

enum { WIDTH = 100, HEIGHT = 90 };

static GpError error;

/* Of bytes that do not compress. */
static GpImage noise(uint8_t *bytes)
{
    Random random = { 5 };
    for (int i = 0; i < 3 * WIDTH * HEIGHT; i++)
        bytes[i] = (uint8_t)random_bits(&random);
    return (GpImage){
        .width = WIDTH, .height = HEIGHT, .channels = 3, .type = GP_IMAGE_U8, .data = bytes
    };
}

static void rows_in_any_portions_make_the_picture(void **state)
{
    (void)state;
    static uint8_t bytes[3 * WIDTH * HEIGHT];
    static const uint32_t portions[] = { 1, 0, 64, HEIGHT - 65 };
    const GpImage image = noise(bytes);
    GpPngRows *rows = NULL;
    uint32_t y = 0;
    assert_int_equal(gp_png_begin(put_text("a.png", "old"), &image, &rows, &error), GP_OK);
    for (size_t i = 0; i < GP_COUNT(portions); y += portions[i++])
        assert_int_equal(gp_png_add(rows, bytes + 3 * WIDTH * y, portions[i], &error), GP_OK);
    assert_int_equal(gp_png_end(&rows, true, &error), GP_OK);
    assert_null(rows);
    GpImage read;
    assert_int_equal(gp_image_read(in_folder("a.png"), &read, &error), GP_OK);
    assert_true(read.width == WIDTH && read.height == HEIGHT && read.channels == 3);
    assert_memory_equal(read.data, bytes, sizeof bytes);
    gp_image_free(&read);
    assert_int_equal(folder_count(false), 1);
}

static void what_is_given_up_leaves_the_old_file(void **state)
{
    (void)state;
    static uint8_t bytes[3 * WIDTH * HEIGHT];
    const GpImage image = noise(bytes);
    char text[16];
    GpPngRows *rows = NULL;
    assert_int_equal(gp_png_begin(put_text("a.png", "old"), &image, &rows, &error), GP_OK);
    assert_int_equal(gp_png_add(rows, bytes, HEIGHT, &error), GP_OK);
    assert_int_equal(gp_png_end(&rows, false, &error), GP_OK);
    assert_int_equal(gp_png_end(&rows, true, &error), GP_OK); /* there is none */
    assert_int_equal(get_text("a.png", text, sizeof text), 3);
    assert_int_equal(folder_count(false), 1);
    assert_int_equal(gp_png_begin(in_folder("no/a.png"), &image, &rows, &error), GP_ERROR_IO);
    assert_null(rows);
    assert_non_null(strstr(error.text, "no/a.png: cannot write"));
}

/* A file has only so much room: at the head, in the midst, or at the end. */
static int write_within(const char *path, rlim_t room)
{
    static uint8_t bytes[3 * WIDTH * HEIGHT];
    const GpImage image = noise(bytes);
    const struct rlimit limit = { room, room };
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    GpPngRows *rows = NULL;
    GpResult result = gp_png_begin(path, &image, &rows, &error);
    if (!result)
        result = gp_png_add(rows, bytes, HEIGHT, &error);
    if (!strstr(error.text, result ? "cannot write" : ""))
        return 9;
    const GpResult end = gp_png_end(&rows, !result, &error);
    return result ? (int)-result : (int)-end;
}

static void a_full_disk_is_told_and_leaves_the_old_file(void **state)
{
    (void)state;
    const char *path = put_text("a.png", "old");
    static const rlim_t rooms[] = { 0, 20, 2000, 3 * WIDTH * HEIGHT };
    for (size_t i = 0; i < GP_COUNT(rooms); i++) {
        char text[16];
        int status;
        const pid_t child = fork();
        if (child == 0)
            _exit(write_within(path, rooms[i])); /* no file of counts within the limit */
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFEXITED(status));
        assert_int_equal(WEXITSTATUS(status), -GP_ERROR_IO);
        assert_int_equal(get_text("a.png", text, sizeof text), 3);
        assert_int_equal(folder_count(false), 1);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)
    const struct CMUnitTest tests[] = {
        TEST(rows_in_any_portions_make_the_picture),
        TEST(what_is_given_up_leaves_the_old_file),
        TEST(a_full_disk_is_told_and_leaves_the_old_file),
    };
    return cmocka_run_group_tests_name("png rows", tests, NULL, NULL);
}
