/* `bench --table' and `chart --scaling' with meshes that are small, or not there; no time is
 * judged. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <sys/stat.h>

/* A tetrahedron with two faces along the axes, in the place of a mesh that tables ask for. */
static void put_mesh(const char *path)
{
    assert_true(mkdir("meshes", 0777) == 0 || access("meshes", X_OK) == 0);
    write_file(path, "ply\nformat ascii 1.0\nelement vertex 4\n"
                     "property float x\nproperty float y\nproperty float z\n"
                     "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
                     "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                     "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

/* Runs the program where no data is but what is put here. */
static int run(const char *arguments)
{
    return shell("unset GLASSPIPE_DATA; glasspipe %s", arguments);
}

/* The next line of the last output as an object; NULL at the end. */
static json_t *next_line(const char **at)
{
    size_t length = strcspn(*at, "\n");
    json_t *object = length ? json_loadb(*at, length, 0, NULL) : NULL;
    if (length && !object)
        fail_msg("no JSON: %s", *at);
    *at += length + (length > 0);
    return object;
}

static double number(json_t *object, const char *key, const char *inner)
{
    json_t *value = json_object_get(object, key);
    value = inner ? json_object_get(value, inner) : value;
    if (!json_is_number(value))
        fail_msg("%s is no number in:\n%s", key, out);
    return json_number_value(value);
}

static void tables_are_known_by_their_numbers(void **state)
{
    (void)state;
    expect_refused(
        2, "bench --table 9.9",
        "2.1, 2.2, 4.1, 4.2, 3.1, 3.2, 003.3, 003.1, 003.2, 003.4, 001.1, 001.2, 002.1, 002.2, "
        "002.3, not '9.9'");
    expect_refused(2, "bench --table", "table");
    expect_refused(2, "bench --table 2.1 mandel", "--table draws scenes of its own");
    assert_int_equal(run("bench --help"), 0);
    expect_contains(out, "2.1, 2.2");
}

static void rows_without_a_file_are_left_out(void **state)
{
    (void)state;
    static const char *const tables[] = { "2.1", "2.2", "4.1", "4.2" };
    for (size_t i = 0; i < GP_COUNT(tables); i++) {
        char arguments[64];
        snprintf(arguments, sizeof arguments, "bench --json -t 0 --table %s", tables[i]);
        assert_int_equal(run(arguments), 0);
        assert_string_equal(out, "");
        expect_contains(err, "skipped");
    }
    expect_files("scene.json");
}

static void table_2_1_has_the_steps_beside_the_print(void **state)
{
    (void)state;
    static const char *const steps[] = { "raster", "texelize", "synthesize", "sort" };
    static const double printed[] = { 12, 8, 11, 27 };
    static const char *const whole[] = { "sheets", "conservative", "thin", "voxels", "targets_mb" };
    put_mesh("meshes/bunny.ply");
    assert_int_equal(run("bench -q --json -t 0 --table 2.1"), 0);
    const char *at = out;
    json_t *row = next_line(&at);
    assert_string_equal(json_string_value(json_object_get(row, "row")), "Bunny");
    assert_string_equal(json_string_value(json_object_get(row, "scene")), "meshes/bunny.ply");
    assert_true(json_is_false(json_object_get(row, "reduced")));
    assert_true(number(row, "triangles", "printed") == 69451);
    assert_true(number(row, "triangles", "measured") == 4);
    for (size_t i = 0; i < GP_COUNT(steps); i++) {
        assert_true(number(row, steps[i], "printed") == printed[i]);
        assert_true(number(row, steps[i], "measured") > 0);
    }
    for (size_t i = 0; i < GP_COUNT(whole); i++)
        assert_true(number(row, whole[i], NULL) > 0);
    assert_null(next_line(&at));
    json_decref(row);
    assert_int_equal(run("bench -q -t 0 --table 2.1"), 0);
    expect_matches(out, "Table 2.1: ");
    expect_matches(out, "Duck +1254 .*not at hand");
    expect_matches(out, "Bunny +69451 +4 .* meshes/bunny.ply");
}

/* Reasons stand below the rows, whether these are there or not; data has none. */
static void why_ranks_are_others_than_printed_stands_below_a_table(void **state)
{
    (void)state;
    static const char reason[] = "\n- mdts and abs fall behind the buckets";
    assert_int_equal(run("bench -q -t 0 --table 002.1"), 0);
    expect_contains(out, "Table 002.1: ");
    expect_contains(out, reason);
    assert_int_equal(run("bench -q --json -t 0 --table 002.1"), 0);
    assert_null(strstr(out, reason + 1));
}

/* What is left of a point is told as it is laid out: the parts, and the area's share, are all. */
static void table_3_1_has_the_bits_of_the_layout(void **state)
{
    (void)state;
    static const double after[] = { 32, 18, 0, 0, 7, 64 };
    assert_int_equal(run("bench -q --json -t 0 --table 3.1"), 0);
    const char *at = out;
    for (size_t i = 0; i < GP_COUNT(after); i++) {
        json_t *row = next_line(&at);
        assert_non_null(row);
        assert_true(number(row, "after", "measured") == after[i]);
        json_decref(row);
    }
    assert_null(next_line(&at));
}

static void table_2_2_has_a_row_for_each_size(void **state)
{
    (void)state;
    static const struct {
        int size, bits;
        double megabytes;
    } rows[] = { { 512, 1, 16 }, { 256, 8, 16 }, { 128, 16, 4 }, { 64, 8, 0.25 } };
    static const char *const pairs[] = { "ms", "voxels", "picture_ms" };
    put_mesh("meshes/bunny.ply");
    assert_int_equal(run("bench -q --json -t 0 --table 2.2"), 0);
    const char *at = out;
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        json_t *row = next_line(&at);
        assert_non_null(row);
        assert_true(number(row, "size", NULL) == rows[i].size);
        assert_true(number(row, "bits", NULL) == rows[i].bits);
        assert_true(number(row, "memory_mb", "printed") == rows[i].megabytes);
        assert_true(number(row, "memory_mb", "measured") == rows[i].megabytes);
        assert_true(number(row, "targets_mb", NULL) >= 3 * rows[i].megabytes);
        for (size_t k = 0; k < GP_COUNT(pairs); k++)
            assert_true(number(row, pairs[k], "measured") > 0);
        json_decref(row);
    }
    assert_null(next_line(&at));
}

static void scaling_is_charted_for_the_meshes_that_are_there(void **state)
{
    (void)state;
    expect_refused(2, "chart shadow --scaling", "shadow has no table");
    expect_refused(2, "chart voxelize meshes/bunny.ply --scaling", "scenes and sizes of its own");
    expect_refused(2, "chart voxelize --size 64 --scaling", "names and settings of its own");
    put_mesh("meshes/bunny.ply");
    assert_int_equal(run("chart voxelize --scaling -t 0 -o charts --json"), 0);
    expect_contains(err, "left out: meshes/horse.ply");
    assert_null(strstr(err, "bunny"));
    json_t *object = parse_output();
    /* four methods in four sizes, and the same with two shapes and one mesh */
    assert_int_equal(json_array_size(json_object_get(object, "points")), 28);
    json_decref(object);
    assert_int_equal(access("charts/voxelize_scaling.svg", R_OK), 0);
    assert_int_equal(access("charts/voxelize_scaling.csv", R_OK), 0);
    static char page[1 << 18];
    read_file("charts/index.html", page, sizeof page);
    expect_contains(page, "Voxelization: time against size");
}

static void a_table_has_no_options_of_cases(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "--images d", "expected none of --images" },
        { "--floor", "expected none of --images" },
        { "--phases", "expected none of --images" },
        { "-l", "expected none of --images" },
        { "clear", "no cases" },
    };
    expect_all_refused(2, "bench --table 4.1", wrong, GP_COUNT(wrong));
    expect_files("scene.json");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_table_has_no_options_of_cases),
        PROGRAM_TEST(tables_are_known_by_their_numbers),
        PROGRAM_TEST(rows_without_a_file_are_left_out),
        PROGRAM_TEST(table_2_1_has_the_steps_beside_the_print),
        PROGRAM_TEST(table_2_2_has_a_row_for_each_size),
        PROGRAM_TEST(table_3_1_has_the_bits_of_the_layout),
        PROGRAM_TEST(why_ranks_are_others_than_printed_stands_below_a_table),
        PROGRAM_TEST(scaling_is_charted_for_the_meshes_that_are_there),
    };
    return cmocka_run_group_tests_name("tables", tests, find_program, NULL);
}
