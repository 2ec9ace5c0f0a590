/* glasspipe points as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <math.h>

#define HEADER                                                                                     \
    "property float x\nproperty float y\nproperty float z\n"                                       \
    "property float nx\nproperty float ny\nproperty float nz\nend_header\n"

static void write_points(void)
{
    unlink("scene.json");
    write_file("four.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    write_file("zero.ply", "ply\nformat ascii 1.0\nelement vertex 4\n" HEADER
                           "0 0 0 0 0 0\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 0\n");
}

/* --- what is refused -------------------------------------------------------------------------- */

static void wrong_arguments_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "", "expected a point file or a mesh" },
        { "a.ply b.ply", "b.ply" },
        { "a.ply --method best", "--method: expected adaptive, ewa" },
        { "a.ply --sums double", "--sums: expected half, float or byte" },
        { "a.ply --lowpass 0", "--lowpass" },
        { "a.ply --spread x", "--spread" },
        { "a.ply --cut 7", "--cut" },
        { "a.ply --epsilon -1", "--epsilon: expected a number from 0 to 1000" },
        { "a.ply --tolerance 2", "--tolerance" },
        { "a.ply --detail -1", "--detail" },
        { "a.ply --budget 0", "--budget: expected a whole number from 1" },
        { "a.ply --subdivide 9", "--subdivide: expected a whole number from 0 to 8" },
        { "a.ply --sample 0", "--sample" },
        { "a.ply --sample 5 --subdivide 1", "--sample and --subdivide" },
        { "a.ply --sharp 0", "--sharp: expected a number from 1 to 179" },
        { "a.ply --camera a.json --from 1 2", "--camera and --from" },
        { "a.ply --from 0 90", "-89 to 89 degrees" },
        { "a.ply --up w", "--up: expected y, z, x, -y or -z" },
        { "a.ply --zoom 0", "--zoom" },
        { "a.ply --color pink", "--color: expected file, white" },
        { "a.ply --color waves:", "--color: expected a number above 0, not ''" },
        { "a.ply --color waves:-3", "not '-3'" },
        { "a.ply --color waves:nan", "not 'nan'" },
        { "a.ply --color waves:4x", "not '4x'" },
        { "a.ply --size 0x5", "--size" },
        { "a.ply --error 1 --method ewa", "--error chooses the setting" },
        { "a.ply -o a.jpg", ".png" },
    };
    unlink("scene.json");
    expect_all_refused(2, "points", wrong, GP_COUNT(wrong));
    expect_files("");
}

/* One line, with the file's name in it where the file is wrong; nothing is written. */
static void wrong_points_are_input_errors_of_one_line(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text;
    } files[] = {
        { "huge.ply", "ply\nformat ascii 1.0\nelement vertex 2147483648\n" HEADER "0 0 0 0 0 1\n" },
        { "short.ply", "ply\nformat ascii 1.0\nelement vertex 3\n" HEADER "0 0 0 0 0 1\n" },
        { "binary.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" HEADER "0123" },
        { "nan.ply",
          "ply\nformat ascii 1.0\nelement vertex 2\n" HEADER "0 0 0 0 0 1\n1 nan 0 0 0 1\n" },
        { "inf.xyz", "0 0 0\n1 0 0\n0 inf 0\n" },
        { "same.xyz", "1 2 3\n1 2 3\n1 2 3\n" },
        { "one.xyz", "1 2 3\n" },
        { "ragged.xyz", "1 2 3\n1 2\n" },
        { "empty.xyz", "" },
        { "count.pts", "5\n1 2 3\n" },
        { "words.xyz", "hello world\n" },
        { "flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n" },
    };
    static const char *const rows[][2] = {
        { "huge.ply", "huge.ply: line 3: 2147483648 elements are promised" },
        { "short.ply", "short.ply: line 10: 3 points are promised" },
        { "binary.ply", "binary.ply: line 10: 3 points are promised, which need 72 bytes" },
        { "nan.ply", "nan.ply: line 12: vertex 1: expected a finite number, found 'nan'" },
        { "inf.xyz", "inf.xyz: line 3: expected a finite number" },
        { "same.xyz", "same.xyz: 3 points at one place" },
        { "one.xyz", "one.xyz: 1 point at one place" },
        { "ragged.xyz", "ragged.xyz: line 2: expected 3 numbers" },
        { "empty.xyz", "empty.xyz: the file is empty" },
        { "count.pts", "count.pts: line 1: 5 points are promised" },
        { "words.xyz", "words.xyz: line 1: expected a finite number, found 'hello'" },
        { "flat.off", "flat.off: no triangle with an area" },
        { "missing.ply", "missing.ply: no such file" },
        { "picture.png", "picture.png: expected a name that ends with .ply" },
        { "builtin:nothing", "no builtin mesh 'nothing'" },
        { "builtin:points/nothing", "no builtin points 'nothing'" },
        { "builtin:points/grid --sample 9", "builtin:points/grid: only a mesh can be" },
        { "four.xyz --sample 100", "four.xyz: only a mesh can be subdivided or sampled" },
        { "four.xyz --subdivide 1", "four.xyz: only a mesh can be subdivided or sampled" },
        { "four.xyz --measure", "a file of points has none" },
        { "builtin:knot --budget 1", "a budget of 1 splats: the coarsest levels in view have" },
    };
    write_points();
    for (size_t i = 0; i < GP_COUNT(files); i++)
        write_file(files[i].name, files[i].text);
    expect_input_errors("points", rows, GP_COUNT(rows));
    for (size_t i = 0; i < GP_COUNT(files); i++)
        unlink(files[i].name);
    expect_files("four.xyz zero.ply");
}

static void wrong_cameras_are_input_errors_of_one_line(void **state)
{
    (void)state;
    static const char *const cameras[][2] = {
        { "{ \"eye\": [0, 0, 3],", "a.json:1: " },
        { "{ \"eye\": [0, 0] }", "a.json:1: eye: expected 3 numbers" },
        { "{ \"eye\": [0, 0, 3], \"at\": [0, 0, 3] }",
          "a.json:1: eye, at and up give no direction" },
        { "{ \"eye\": [0, 0, 3], \"at\": [0, 0, 0], \"up\": [0, 0, 1] }", "give no direction" },
        { "{\n\"fovy\": 400 }", "a.json:2: fovy: expected a number in [0.1, 170]" },
        { "{ \"near\": 3, \"far\": 2 }", "a.json:1: " },
        { "{ \"lens\": 5 }", "a.json:1: lens: unknown key" },
        { "[ 1, 2 ]", "a.json" },
    };
    write_points();
    for (size_t i = 0; i < GP_COUNT(cameras); i++) {
        const char *const row[][2] = { { "four.xyz --camera a.json", cameras[i][1] } };
        write_file("a.json", cameras[i][0]);
        expect_input_errors("points", row, 1);
    }
    static const char *const rows[][2] = { { "four.xyz --camera none.json", "none.json" } };
    expect_input_errors("points", rows, 1);
    expect_files("a.json four.xyz zero.ply");
}

/* --- what is drawn ---------------------------------------------------------------------------- */

static void points_are_drawn_and_reported(void **state)
{
    (void)state;
    write_points();
    assert_int_equal(shell("glasspipe points four.xyz -q --size 64x48 --report"), 0);
    expect_matches(out, "^hash A8R8G8B8 64x48 [0-9a-f]{16}\npoints 4; the file has 4 points\n"
                        "normals 4 estimated; radii 4 estimated; colours white\n");
    assert_int_equal(shell("glasspipe points zero.ply -q --size 64x48 --report"), 0);
    expect_contains(out, "normals 2 estimated, which were zero in the file: 2;");
    expect_files("four.png four.xyz zero.ply zero.png");
}

static void builtin_points_are_drawn(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe points builtin:points/sphere -q --size 32x32 --report"), 0);
    expect_contains(out, "points 5,000; the file has 5,000 points\nnormals of the file;");
    assert_int_equal(shell("glasspipe points builtin:points/grid -q --size 32x32 --report"), 0);
    expect_contains(out, "points 4,096;");
    unlink("grid.png");
    unlink("sphere.png");
}

/* A millimetre from each other, at the origin and four thousand kilometres from it. */
static void coordinates_that_floats_cannot_hold_are_warned_of(void **state)
{
    (void)state;
    for (int far = 0; far < 2; far++) {
        char text[8000] = "";
        for (int i = 0; i < 100; i++)
            snprintf(text + strlen(text), 60, "%.3f %.3f 7\n", far * 4e6 + 0.001 * (i % 10),
                     far * 1e4 + 0.001 * (i / 10));
        write_file("a.xyz", text);
        assert_int_equal(shell("glasspipe points a.xyz --size 32x32"), 0);
        if (far)
            expect_contains(err, "warning: a.xyz: coordinates are rounded to steps of 0.25");
        else
            assert_null(strstr(err, "warning"));
    }
    unlink("a.xyz");
    unlink("a.png");
}

/* Discs that are larger than the box of their centres are seen whole. */
/* Where the eye is so far away that small steps are lost. */
static void models_may_be_as_large_as_floats(void **state)
{
    (void)state;
    static const char *const sides[] = { "3", "3e9", "3e12" };
    for (size_t i = 0; i < GP_COUNT(sides); i++) {
        char file[400];
        snprintf(file, sizeof file,
                 "ply\nformat ascii 1.0\nelement vertex 3\n"
                 "property float x\nproperty float y\nproperty float z\nelement face 1\n"
                 "property list uchar int vertex_indices\nend_header\n"
                 "0 0 0\n%s 0 0\n0 %s 0\n3 0 1 2\n",
                 sides[i], sides[i]);
        write_file("large.ply", file);
        assert_int_equal(shell("glasspipe points large.ply -q --size 32x32 --measure"), 0);
        expect_contains(out, ", 0 holes in");
    }
    assert_int_equal(unlink("large.ply") | unlink("large.png"), 0);
}

static void one_point_is_a_picture(void **state)
{
    (void)state;
    write_points();
    write_file("one.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float radius\n" HEADER
                          "0.5 7 7 7 0.5 0.5 0.7\n");
    write_file("away.json", "{ \"eye\": [0, 0, 0], \"at\": [-1, -1, -1] }");
    assert_int_equal(shell("glasspipe points one.ply -q --size 32x32 --camera away.json"), 0);
    char empty[128];
    snprintf(empty, sizeof empty, "%.120s", out);
    assert_int_equal(shell("glasspipe points one.ply -q --size 32x32"), 0);
    assert_string_not_equal(out, empty);
    unlink("one.ply");
    unlink("away.json");
    unlink("one.png");
    expect_files("four.xyz zero.ply");
}

/* Beside its remedy: faces that end at an edge as discs, and at clip lines. */
static void a_cube_has_sharp_edges(void **state)
{
    (void)state;
    double decibels[2], area[2];
    for (int sharp = 0; sharp < 2; sharp++) {
        assert_int_equal(shell("glasspipe points builtin:cube --subdivide 3 --method ewa %s "
                               "--size 128x128 --measure --json -q -o a.png",
                               sharp ? "--sharp 40" : ""),
                         0);
        json_t *object = parse_output();
        decibels[sharp] = json_real_value(json_object_get(object, "interior_psnr"));
        area[sharp] = json_real_value(json_object_get(object, "area_error"));
        json_decref(object);
    }
    /* discs of a face reach a pixel and more beyond it: a quarter of the error, at most, is left */
    if (!(decibels[1] > decibels[0] + 12 && area[0] > 0.02 && fabs(area[1]) < 0.002))
        fail_msg("%g dB, then %g; areas %g, %g", decibels[0], decibels[1], area[0], area[1]);
}

/* By the default method too, which leaves out no clip. */
static void sharp_edges_need_no_method(void **state)
{
    (void)state;
    static const char *const methods[] = { "", "--method ewa", "--method adaptive" };
    char hashes[3][64];
    for (int i = 0; i < 3; i++) {
        assert_int_equal(shell("glasspipe points builtin:cube --subdivide 3 --sharp 40 %s "
                               "--size 128x128 --json -q -o a.png",
                               methods[i]),
                         0);
        json_t *object = parse_output();
        snprintf(hashes[i], sizeof hashes[i], "%s",
                 json_string_value(json_object_get(object, "hash")));
        json_decref(object);
        assert_string_equal(hashes[i], hashes[0]);
    }
}

static void json_has_what_checks_ask_for(void **state)
{
    (void)state;
    static const char *const members[] = {
        "hash",          "points",     "splats", "splats_per_second", "bytes_per_point",
        "interior_psnr", "area_error", "holes",  "setting",           "ms"
    };
    assert_int_equal(
        shell("glasspipe points builtin:torus --size 96x96 --measure --json -q -o a.exr"), 0);
    json_t *object = parse_output();
    for (size_t i = 0; i < GP_COUNT(members); i++)
        if (!json_object_get(object, members[i]))
            fail_msg("%s is missing in:\n%s", members[i], out);
    assert_true(json_real_value(json_object_get(object, "interior_psnr")) > 25);
    assert_int_equal(json_integer_value(json_object_get(object, "holes")), 0);
    json_decref(object);
}

/* The README shows them. */
static void stored_pictures_are_what_their_commands_draw(void **state)
{
    (void)state;
    static const char *const pictures[][2] = {
        { "points_pixels", "pixels" },
        { "points_discs", "sprites" },
        { "points_splats", "ewa" },
    };
    for (size_t i = 0; i < GP_COUNT(pictures); i++) {
        assert_int_equal(shell("glasspipe points -q builtin:knot --size 256x256 --zoom 1.5 "
                               "--color clay --method %s -o a.png",
                               pictures[i][1]),
                         0);
        expect_stored_picture(pictures[i][0]);
    }
}

static void words_of_a_vector_stand_together_or_apart(void **state)
{
    (void)state;
    static const char *const same[] = { "--from 20 40", "--from '20 40'", "--from='20 40'",
                                        "--from=20 40", "--from ' 20  40 '" };
    static const char *const wrong[][2] = {
        { "--from 30 '20 foo'", "not 'foo'" },
        { "--from '30 20 10'", "not '10'" },
        { "--from 30 --measure", "'--measure'" },
        { "--from '' 30 20", "not ''" },
        { "--from 30", "not ''" },
    };
    static char first[sizeof out];
    for (size_t i = 0; i < GP_COUNT(same); i++) {
        assert_int_equal(
            shell("glasspipe points %s builtin:knot --size 16x16 -q -o a.ppm", same[i]), 0);
        if (i == 0)
            strcpy(first, out);
        assert_string_equal(out, first);
    }
    assert_int_equal(shell("glasspipe points builtin:knot --size 16x16 -q -o a.ppm"), 0);
    assert_string_not_equal(out, first);
    assert_int_equal(
        shell("glasspipe points builtin:knot --from '30 20' --measure --size 16x16 -q -o a.ppm"),
        0);
    expect_contains(out, "covered pixels");
    expect_all_refused(2, "points builtin:knot -o a.ppm", wrong, GP_COUNT(wrong));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(words_of_a_vector_stand_together_or_apart),
        PROGRAM_TEST(wrong_arguments_are_usage_errors),
        PROGRAM_TEST(wrong_points_are_input_errors_of_one_line),
        PROGRAM_TEST(wrong_cameras_are_input_errors_of_one_line),
        PROGRAM_TEST(points_are_drawn_and_reported),
        PROGRAM_TEST(builtin_points_are_drawn),
        PROGRAM_TEST(coordinates_that_floats_cannot_hold_are_warned_of),
        PROGRAM_TEST(models_may_be_as_large_as_floats),
        PROGRAM_TEST(one_point_is_a_picture),
        PROGRAM_TEST(a_cube_has_sharp_edges),
        PROGRAM_TEST(sharp_edges_need_no_method),
        PROGRAM_TEST(json_has_what_checks_ask_for),
        PROGRAM_TEST(stored_pictures_are_what_their_commands_draw),
    };
    return cmocka_run_group_tests_name("points", tests, find_program, NULL);
}
