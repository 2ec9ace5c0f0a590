/* Files that are replaced: where links lead, and what is left when a writer is stopped. */
#include "pipeline/io/file.h"

#include "tests/support/folder.h"

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

static void abandon(int number)
{
    (void)number;
    gp_file_abandon();
    _exit(7);
}

/* The limit of a file's size raises its signal in the midst of the write. */
static void write_beyond_the_limit(const char *path)
{
    static const char data[4000];
    const struct rlimit limit = { 1000, 1000 };
    signal(SIGXFSZ, abandon);
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
        write_beyond_the_limit(path);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 7);
    assert_int_equal(folder_count(false), 1);
    assert_int_equal(get_text("a", text, sizeof text), 3);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)
    const struct CMUnitTest tests[] = {
        TEST(a_link_to_nothing_yet_is_followed),
        TEST(a_link_to_an_absolute_place_is_followed),
        TEST(a_circle_of_links_is_refused),
        TEST(a_stopped_write_leaves_the_old_file_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
