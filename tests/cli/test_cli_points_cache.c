/* What is built of points, kept in a file: the same picture with it, and without what is wrong in
 * it. */
#include "tests/support/program.h"

#include <sys/stat.h>

static char hash[64];

/* Draws with the cache, and says the same hash as ever. */
static void expect_drawn(const char *model, const char *warning)
{
    assert_int_equal(shell("glasspipe points %s --size 64x64 --cache built.bin -o a.png", model),
                     0);
    if (!hash[0])
        snprintf(hash, sizeof hash, "%.*s", (int)sizeof hash - 1, out);
    assert_string_equal(out, hash);
    if (warning)
        expect_contains(err, warning);
    else
        assert_null(strstr(err, "warning"));
}

/* Changes a byte of the file. */
static void damage(long at)
{
    FILE *file = fopen("built.bin", "r+");
    assert_non_null(file);
    assert_int_equal(fseek(file, at, SEEK_SET), 0);
    const int byte = fgetc(file);
    assert_int_equal(fseek(file, at, SEEK_SET), 0);
    assert_int_equal(fputc(byte ^ 0x55, file), byte ^ 0x55);
    assert_int_equal(fclose(file), 0);
}

static void a_cache_changes_no_picture(void **state)
{
    (void)state;
    const char knot[] = "builtin:knot --detail 1";
    hash[0] = '\0';
    expect_drawn(knot, NULL);
    expect_files("a.png built.bin scene.json");
    expect_drawn(knot, NULL);
    damage(9);
    expect_drawn(knot, "built.bin: a cache of another version: built anew");
    damage(2000);
    expect_drawn(knot, "built.bin: damaged");
    assert_int_equal(truncate("built.bin", 5000), 0);
    expect_drawn(knot, "built.bin: truncated: 5000 bytes of");
    expect_drawn(knot, NULL);
    /* with all there is to tell of the input, which is read for it */
    assert_int_equal(
        shell("glasspipe points %s --size 64x64 --cache built.bin --report -o a.png", knot), 0);
    expect_contains(out, hash);
}

static void a_cache_of_other_points_is_written_over(void **state)
{
    (void)state;
    hash[0] = '\0';
    expect_drawn("builtin:knot --detail 1", NULL);
    hash[0] = '\0';
    expect_drawn("builtin:knot --detail 1 --color gold",
                 "a cache of another model or of other settings");
    expect_drawn("builtin:knot --detail 1 --color gold", NULL);
    hash[0] = '\0';
    expect_drawn("builtin:torus --detail 1", "a cache of another model or of other settings");
    expect_drawn("builtin:torus --detail 1", NULL);
    hash[0] = '\0';
    expect_drawn("builtin:torus --detail 1 --sample 3000",
                 "a cache of another model or of other settings");
}

/* The packed form is kept alone, in less than half of the bytes, and not taken for another. */
static void a_cache_of_compressed_points_is_small(void **state)
{
    (void)state;
    const char *const forms[] = { "ours", "printed" };
    struct stat plain, packed;
    hash[0] = '\0';
    expect_drawn("builtin:knot --sample 30000", NULL);
    assert_int_equal(stat("built.bin", &plain), 0);
    for (int i = 0; i < 2; i++) {
        char model[64];
        snprintf(model, sizeof model, "builtin:knot --sample 30000 --compress %s", forms[i]);
        hash[0] = '\0';
        expect_drawn(model, "a cache of another model or of other settings");
        expect_drawn(model, NULL);
        assert_int_equal(stat("built.bin", &packed), 0);
        assert_true(2 * packed.st_size < plain.st_size);
        /* with levels of detail too, none of which is kept otherwise */
        strncat(model, " --detail 1", sizeof model - strlen(model) - 1);
        hash[0] = '\0';
        expect_drawn(model, NULL);
        expect_drawn(model, NULL);
        damage(40000);
        expect_drawn(model, "built.bin: damaged");
    }
}

/* What is no cache is somebody's: the input itself, or any other file. */
static void a_file_that_is_no_cache_is_left_alone(void **state)
{
    (void)state;
    static const char points[] = "0 0 0 0 0 1 0.1\n1 0 0 0 0 1 0.1\n0 1 0 0 0 1 0.1\n";
    static const char *const lines[] = {
        "points pt.xyz --cache pt.xyz -o a.png",
        "points builtin:knot --cache pt.xyz -o a.png",
        "fragments builtin:ball --method convex --cache pt.xyz -o a.exr",
        "inspect scene.json --technique fragments --method convex --cache pt.xyz -o a.html",
    };
    char text[sizeof points + 8];
    write_file("pt.xyz", points);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        expect_refused(2, lines[i], "--cache pt.xyz: the file is there, and is no cache");
        read_file("pt.xyz", text, sizeof text);
        assert_string_equal(text, points);
    }
    write_file("built.bin", "gpp");
    expect_refused(2, "points builtin:knot --cache built.bin -o a.png", "is no cache");
    hash[0] = '\0';
    write_file("built.bin", "");
    expect_drawn("builtin:knot --detail 1", "built.bin: not a cache of points: built anew");
    expect_drawn("builtin:knot --detail 1", NULL);
    damage(3);
    expect_refused(2, "points builtin:knot --detail 1 --cache built.bin -o a.png", "is no cache");
}

static void a_cache_that_cannot_be_written_is_a_warning(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe points builtin:knot --size 64x64 --cache no/where -o a.png"),
                     0);
    expect_contains(err, "warning: no/where: ");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_cache_changes_no_picture),
        PROGRAM_TEST(a_cache_of_other_points_is_written_over),
        PROGRAM_TEST(a_cache_of_compressed_points_is_small),
        PROGRAM_TEST(a_file_that_is_no_cache_is_left_alone),
        PROGRAM_TEST(a_cache_that_cannot_be_written_is_a_warning),
    };
    return cmocka_run_group_tests(tests, find_program, NULL);
}
