/* Files that are read whole, or replaced: where links lead, and what is left when a writer is
 * stopped. */
#define _GNU_SOURCE /* O_TMPFILE */
#include "pipeline/io/file.h"

#include "tests/support/folder.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

static GpError error;

static void a_link_to_nothing_yet_is_followed(void **state)
{
    (void)state;
    char text[16];
    assert_int_equal(mkdir(in_folder("far"), 0777), 0);
    assert_int_equal(symlink("far/second", in_folder("first")), 0);
    assert_int_equal(symlink("target", in_folder("far/second")), 0); /* beside the second link */
    assert_int_equal(gp_file_write(in_folder("first"), "through", 7, &error), GP_OK);
    assert_int_equal(get_text("far/target", text, sizeof text), 7);
    assert_string_equal(text, "through");
    struct stat info;
    assert_int_equal(lstat(in_folder("first"), &info), 0);
    assert_true(S_ISLNK(info.st_mode));
    assert_int_equal(remove(in_folder("far/second")), 0);
    assert_int_equal(remove(in_folder("far/target")), 0);
}

static void a_link_to_an_absolute_place_is_followed(void **state)
{
    (void)state;
    char text[16];
    assert_int_equal(symlink(in_folder("target"), in_folder("link")), 0);
    assert_int_equal(gp_file_write(in_folder("link"), "through", 7, &error), GP_OK);
    assert_int_equal(get_text("target", text, sizeof text), 7);
}

static void a_circle_of_links_is_refused(void **state)
{
    (void)state;
    assert_int_equal(symlink("b", in_folder("a")), 0);
    assert_int_equal(symlink("a", in_folder("b")), 0);
    assert_int_equal(gp_file_write(in_folder("a"), "x", 1, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "cannot write"));
    assert_int_equal(folder_count(false), 2);
}

static void what_has_nothing_to_replace_is_written_straight(void **state)
{
    (void)state;
    assert_int_equal(gp_file_write("/dev/null", "gone", 4, &error), GP_OK);
    assert_int_equal(gp_file_write("/dev/full", "full", 4, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "/dev/full: cannot write"));
    assert_int_equal(gp_file_write(folder, "x", 1, &error), GP_ERROR_IO);
    assert_int_equal(folder_count(false), 0);
}

/* The kernel says of its files that they fill a page, and then they have a line. */
static void a_file_that_ends_early_is_refused(void **state)
{
    (void)state;
    static const char path[] = "/sys/devices/system/cpu/online";
    struct stat info;
    GpFile file = { .data = NULL };
    if (stat(path, &info) || info.st_size < 4096)
        skip();
    assert_int_equal(gp_file_read(path, &file, &error), GP_ERROR_IO);
    assert_string_equal(error.text,
                        "/sys/devices/system/cpu/online: became shorter while it was read");
    assert_null(file.data);
}

/* Paths that no system takes: as they are, and by a link that makes them longer. */
static void paths_that_are_too_long_are_refused(void **state)
{
    (void)state;
    char path[6000], found[8] = "as ever";
    memset(path, 'x', sizeof path);
    path[sizeof path - 1] = '\0';
    assert_int_equal(gp_file_write(path, "x", 1, &error), GP_ERROR_IO);
    assert_int_equal(gp_data_find(path, found, sizeof found, &error), GP_ERROR_IO);
    GpFilePieces *pieces = NULL;
    assert_int_equal(gp_file_begin(path, &pieces, &error), GP_ERROR_IO);
    assert_null(pieces);
    assert_int_equal(gp_file_end(&pieces, true, &error), GP_OK);
    assert_int_equal(gp_data_find(put_text("a", "there"), found, sizeof found, &error),
                     GP_ERROR_IO);
    assert_non_null(strstr(error.text, "the path is longer than 8 bytes"));
    assert_int_equal(gp_data_find(in_folder("none"), found, sizeof found, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "none: no such file"));
    assert_int_equal(gp_data_find("", found, sizeof found, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "no name"));
    assert_string_equal(found, "as ever");
}

static void abandon(int number)
{
    (void)number;
    gp_file_abandon();
    _exit(7);
}

/* The limit of a file's size raises its signal in the midst of the write. */
static void write_beyond_the_limit(const char *path, void (*then)(int))
{
    static const char data[4000];
    const struct rlimit limit = { 1000, 1000 };
    signal(SIGXFSZ, then);
    setrlimit(RLIMIT_FSIZE, &limit);
    gp_file_write(path, data, sizeof data, &error);
    _exit(1);
}

static void a_stopped_write_leaves_the_old_file_alone(void **state)
{
    (void)state;
    char text[16];
    const char *path = put_text("a", "old");
    const pid_t child = fork();
    if (child == 0)
        write_beyond_the_limit(path, abandon);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 7);
    assert_int_equal(folder_count(false), 1);
    assert_int_equal(get_text("a", text, sizeof text), 3);
}

/* Nobody can clear up behind a process that is killed: what it wrote has no name yet. */
static void a_killed_write_leaves_nothing(void **state)
{
    (void)state;
    const int nameless = open(in_folder("."), O_WRONLY | O_TMPFILE, 0666);
    if (nameless < 0)
        skip(); /* the file system has no files without a name */
    close(nameless);
    const char *path = put_text("a", "old");
    const pid_t child = fork();
    if (child == 0)
        write_beyond_the_limit(path, SIG_DFL);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(folder_count(false), 1);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)
    const struct CMUnitTest tests[] = {
        TEST(a_link_to_nothing_yet_is_followed),
        TEST(a_link_to_an_absolute_place_is_followed),
        TEST(a_circle_of_links_is_refused),
        TEST(a_stopped_write_leaves_the_old_file_alone),
        TEST(a_killed_write_leaves_nothing),
        TEST(what_has_nothing_to_replace_is_written_straight),
        TEST(a_file_that_ends_early_is_refused),
        TEST(paths_that_are_too_long_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
