/* glasspipe warp as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <math.h>

static void write_cameras(void)
{
    unlink("scene.json");
    write_file("one_place.json", "{ \"eye\": [1, 2, 3], \"at\": [1, 2, 3] }");
    write_file("ahead.json", "{ \"eye\": [0, 1, 9], \"at\": [0, 1, 0] }");
    write_file("far.json", "{ \"eye\": [0, 0, 9000], \"near\": 10, \"far\": 10000 }");
    write_file("inside.json", "{ \"eye\": [0.1, 0.2, 0], \"at\": [0, 0, 1], \"near\": 0.01 }");
    write_file("behind.json", "{ \"eye\": [0, 1, -9], \"at\": [0, 1, 0] }");
    write_file("parallel.json", "{ \"eye\": [0, 2, 9], \"at\": [0, 1, 0], \"height\": 5 }");
}

#define CAMERAS "ahead.json behind.json far.json inside.json one_place.json parallel.json"

/* --- what is refused -------------------------------------------------------------------------- */

static void wrong_arguments_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "", "expected a mesh or a depth image" },
        { "a.ply b.ply", "b.ply" },
        { "a.ply --method best", "--method: expected auto" },
        { "a.ply --step 0", "--step: expected a whole number from 1 to 128" },
        { "a.ply --step -1", "--step: expected a whole number from 1 to 128" },
        { "a.ply --step 10000", "--step: expected a whole number from 1 to 128" },
        { "a.ply --method relief --step 2", "--step does not go with --method relief" },
        { "a.ply --method surface --search 9", "--search does not go with --method surface" },
        { "a.ply --method cylinder --kind planar", "does not draw images of --kind planar" },
        { "a.ply --method relief --kind cylinder", "does not draw images of --kind cylinder" },
        { "a.ply --search 256", "--search" },
        { "a.ply --cut deep", "--cut: expected auto, slopes, relative or none" },
        { "a.ply --method surface --cut none", "--cut does not go with --method surface" },
        { "a.ply --method planar --cut relative", "does not go with --method planar" },
        { "a.ply --method layers --entries 9", "--entries does not go with" },
        { "a.ply --method relief-texture --cut slopes",
          "does not go with --method relief-texture" },
        { "a.ply --kind cylinder --cut none", "--cut does not go with --method surface" },
        { "a.ply --kind box --tolerance 5", "--tolerance does not go with --method surface" },
        { "a.ply --kind cylinder --detail b.png --cut none",
          "--cut does not go with --method cylinder" },
        { "a.ply --tolerance 17", "--tolerance: expected a number from -1 to 16" },
        { "a.ply --halvings 0", "--halvings" },
        { "a.ply --share 0", "--share: expected a number from 0.001 to 1" },
        { "a.ply --method dmesh --share 0.5", "--share does not go with --method dmesh" },
        { "a.ply --field 7", "--field: expected a whole number from 8 to 512" },
        { "a.ply --method relief --field 9", "--field does not go with --method relief" },
        { "a.ply --method surface --detail b.png", "--detail does not go with --method surface" },
        { "a.ply --detail-depth 1", "--detail-depth and --detail-repeat are for --detail" },
        { "a.ply --detail b.png --detail-depth deep", "--detail-depth: expected a number" },
        { "a.ply --detail b.png --detail-repeat 0", "--detail-repeat: expected a whole number" },
        { "a.ply --detail b.png --tolerance 2", "--tolerance does not go with --detail" },
        { "a.ply --detail b.png --measure", "--truth names one that has it" },
        { "a.ply --kind ball", "--kind: expected planar, cylinder or box" },
        { "a.ply --source-size 0x5", "--source-size" },
        { "a.ply --source-size 5000x5", "--source-size" },
        { "a.ply --turn 181", "--turn: expected a number from -180 to 180" },
        { "a.ply --turn 5 --from 1 2", "--turn is about the source" },
        { "a.ply --turn 5 --camera a.json", "--turn is about the source" },
        { "a.ply --camera a.json --from 1 2", "--camera and --from" },
        { "a.ply --from 0 90", "-89 to 89 degrees" },
        { "a.ply --zoom 2", "--zoom is for --from" },
        { "a.ply --up w", "--up: expected y, z, x, -y or -z" },
        { "a.ply --color pink", "--color: expected file, white" },
        { "a.ply --color waves:0", "--color: expected a number above 0" },
        { "a.ply --truth b.ply", "--truth is for --measure" },
        { "a.ply --size 0x5", "--size" },
        { "a.ply --error 1 --turn 1", "--error chooses the setting" },
        { "a.ply -o a.nrrd", ".png" },
    };
    unlink("scene.json");
    expect_all_refused(2, "warp", wrong, GP_COUNT(wrong));
    expect_files("");
}

/* One line, with the file's name in it; nothing is written. */
static void wrong_files_are_input_errors_of_one_line(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "missing.ply", "missing.ply: no such file" },
        { "builtin:nothing", "no builtin mesh 'nothing'" },
        { "empty.off", "empty.off: no faces" },
        { "nan.off", "nan.off: line 3" },
        { "far.json", "far.json: a scene: expected a mesh, or a depth image, .exr" },
        { "a.png", "a.png: a picture: expected a mesh, or a depth image, .exr" },
        { "builtin:ball --error 1% --detail even.ppm", "the mesh lacks what --detail adds" },
        { "builtin:ball --camera one_place.json", "one_place.json:1: eye, at and up give" },
        { "builtin:ball --source one_place.json", "one_place.json:1: eye, at and up give" },
        { "builtin:ball --source missing.json", "missing.json: No such file" },
        { "builtin:ball --detail missing.png", "missing.png: no such file" },
        { "builtin:ball --detail nan.off", "nan.off" },
        { "builtin:ball --measure --truth missing.ply", "missing.ply: no such file" },
    };
    write_cameras();
    write_file("empty.off", "OFF\n1 0 0\n0 0 0\n");
    write_file("even.ppm", "P6 1 1 255\n~~~");
    write_file("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_input_errors("warp -o a.png", rows, GP_COUNT(rows));
    expect_files(
        "ahead.json behind.json empty.off even.ppm far.json inside.json nan.off one_place.json "
        "parallel.json");
}

/* --- what is drawn ---------------------------------------------------------------------------- */

#define MEASURED                                                                                   \
    "(interior [0-9.]+ dB, )?[0-9]+ missing and [0-9]+ extra of [0-9]+ pixels, depth off by "      \
    "[0-9.e+-]+ \\(median; mean [0-9.e+-]+\\)\n$"

/* From inside, from behind, from so far that all is in a pixel, and pictures of one. */
static void odd_places_and_sizes_are_drawn(void **state)
{
    (void)state;
    static const char *const arguments[] = {
        "--camera ahead.json",
        "--camera behind.json",
        "--camera far.json",
        "--camera inside.json",
        "--camera parallel.json",
        "--source parallel.json",
        "--source inside.json",
        "--source far.json",
        "--from 200 -80 --zoom 3",
        "--turn 180",
        "--size 1x1",
        "--source-size 1x1",
        "--source-size 2x2 --size 1x40",
        "--truth builtin:knot",
    };
    write_cameras();
    for (size_t i = 0; i < GP_COUNT(arguments); i++) {
        const bool has_size = strstr(arguments[i], "--size");
        if (shell("glasspipe warp builtin:ball -q -o a.exr --measure %s %s", arguments[i],
                  has_size ? "" : "--size 40x30"))
            fail_msg("%s: %s", arguments[i], err);
        expect_matches(out, "^hash A8R8G8B8 [0-9x]+ [0-9a-f]{16}\n(seen .*\n)?" MEASURED);
    }
    expect_files("a.exr " CAMERAS);
}

/* Also where the truth is looked for before any setting is drawn. */
static void a_truth_has_the_colour_that_was_asked_for(void **state)
{
    (void)state;
    static const char *const errors[] = { "", "--error 20" };
    unlink("scene.json");
    for (size_t i = 0; i < GP_COUNT(errors); i++) {
        shell(
            "glasspipe warp builtin:knot --color gold --truth builtin:knot --size 96x96 --measure "
            "--json -q -o a.png %s",
            errors[i]);
        json_t *object = parse_output();
        assert_true(json_real_value(json_object_get(object, "interior_psnr")) > 24);
        json_decref(object);
    }
}

static void json_has_what_checks_ask_for(void **state)
{
    (void)state;
    static const char *const members[] = { "hash",          "triangles",     "triangles_per_second",
                                           "source_pixels", "setting",       "view",
                                           "warnings",      "interior_psnr", "missing",
                                           "extra",         "depth_error",   "depth_mean",
                                           "coverage" };
    unlink("scene.json");
    assert_int_equal(shell("glasspipe warp builtin:knot --color waves:9 --size 96x96 --measure "
                           "--method polygons --json -q -o a.exr --output-coverage b.png"),
                     0);
    json_t *object = parse_output();
    for (size_t i = 0; i < GP_COUNT(members); i++)
        if (!json_object_get(object, members[i]))
            fail_msg("%s is missing in:\n%s", members[i], out);
    /* the mesh against itself */
    assert_true(json_real_value(json_object_get(object, "interior_psnr")) > 40);
    assert_true(json_integer_value(json_object_get(object, "missing")) < 3);
    assert_true(json_real_value(json_object_get(object, "depth_error")) < 1e-4);
    json_decref(object);
    expect_files("a.exr b.png");
}

static void options_of_one_method_mean_it(void **state)
{
    (void)state;
    static const char *const options[][2] = {
        { "--search 9", "--method relief --search 9" },
        { "--entries 300", "--method planar --entries 300" },
        { "--unlimited", "--method parallax --unlimited" },
        { "--halvings 3", "--method relief --halvings 3" },
        { "--share 0.5", "--method simplified --share 0.5" },
        { "--field 32", "--method displacement --field 32" },
        { "--method cylinder", "--method cylinder --kind cylinder" },
        { "", "--method layers" },
        { "--cut none", "--method layers --cut none" },
        { "--kind cylinder", "--method surface --kind cylinder" },
    };
    unlink("scene.json");
    expect_same_settings("warp builtin:ball --source-size 16x16 --size 32x32", options,
                         GP_COUNT(options));
}

/* Of every kind; even heights stand out everywhere alike, and are of no more than one colour. */
static void small_relief_is_laid_over_all_kinds(void **state)
{
    (void)state;
    static const char *const options[][2] = {
        { "", "--method layers" },
        { "--method planar", "--method planar" },
        { "--kind cylinder", "--method cylinder " },
        { "--kind box --turn 40", "--method layers " },
    };
    unlink("scene.json");
    write_file("rough.ppm", "P6 2 2 255\n000~~~~~~000");
    write_file("even.ppm", "P6 2 2 255\n~~~~~~~~~~~~");
    for (size_t i = 0; i < GP_COUNT(options); i++) {
        char hashes[3][32];
        const char *const details[] = { "", "--detail even.ppm", "--detail rough.ppm" };
        for (int k = 0; k < 3; k++) {
            if (shell("glasspipe warp builtin:teapot --source-size 96x96 --size 96x96 -q --json "
                      "-o a.png %s %s",
                      options[i][0], details[k]))
                fail_msg("%s: %s", options[i][0], err);
            json_t *object = parse_output();
            snprintf(hashes[k], sizeof hashes[k], "%s",
                     json_string_value(json_object_get(object, "hash")));
            if (k > 0)
                expect_contains(json_string_value(json_object_get(object, "setting")),
                                options[i][1]);
            json_decref(object);
        }
        assert_true(strcmp(hashes[0], hashes[1]) && strcmp(hashes[1], hashes[2]));
    }
    expect_files("a.png even.ppm rough.ppm");
}

/* As a line, and in JSON. */
static void what_a_method_cannot_do_is_named(void **state)
{
    (void)state;
    write_cameras();
    assert_int_equal(shell("glasspipe warp builtin:ball --method cylinder --camera inside.json "
                           "--source-size 32x32 --size 32x32 --json -o a.png"),
                     0);
    expect_contains(err, "warning: the eye is inside the cylinder");
    json_t *object = parse_output();
    const json_t *warnings = json_object_get(object, "warnings");
    assert_int_equal(json_array_size(warnings), 2);
    expect_contains(json_string_value(json_array_get(warnings, 0)), "inside the cylinder");
    expect_contains(json_string_value(json_array_get(warnings, 1)), "the picture is empty");
    json_decref(object);
    static const char *const rows[][2] = {
        { "--turn 180", "sees a planar depth image from behind" },
        { "--turn 180 --method relief", "sees a planar depth image from behind" },
        { "--turn 180 --method surface", "sees a planar depth image from behind" },
        { "--camera away.json --kind cylinder", "the picture is empty" },
    };
    write_file("away.json", "{ \"eye\": [0, 0, 9], \"at\": [0, 0, 10] }");
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        assert_int_equal(shell("glasspipe warp builtin:ball --source-size 32x32 --size 32x32 -o "
                               "a.png %s",
                               rows[i][0]),
                         0);
        expect_contains(err, rows[i][1]);
    }
    assert_int_equal(shell("glasspipe warp builtin:ball --source-size 32x32 -o a.png --kind box"),
                     0); /* half of its faces look away, as they should */
    assert_null(strstr(err, "warning"));
}

/* The README shows them. */
static void stored_pictures_are_what_their_commands_draw(void **state)
{
    (void)state;
    static const char *const pictures[][2] = {
        { "source", "--turn 0" },
        { "sheets", "--turn -20 --method planar" },
        { "holes", "--turn -20 --method direct" },
        { "layers", "--turn -20" },
    };
    unlink("scene.json");
    for (size_t i = 0; i < GP_COUNT(pictures); i++) {
        assert_int_equal(
            shell("glasspipe warp builtin:teapot -q --size 256x256 %s -o a.png", pictures[i][1]),
            0);
        if (shell("glasspipe compare a.png '%s/../../scenes/pictures/warp_%s.png'", man_pages,
                  pictures[i][0]))
            fail_msg("%s: %s%s", pictures[i][0], out, err);
    }
}

/* An image that went through a file is the one that was captured, seen from where it was taken it
 * is its own truth, and what does not go with it is refused. */
static void images_of_files_are_those_that_were_captured(void **state)
{
    (void)state;
    char first[64];
    unlink("scene.json");
    write_file("aside.json", "{ \"eye\": [1, 1, 5], \"at\": [0, 0, 0], \"near\": 1, \"far\": 9 }");
    assert_int_equal(
        shell("glasspipe warp builtin:knot --color waves:9 --source-size 64x64 --camera aside.json "
              "--size 64x64 -q -o a.png"),
        0);
    snprintf(first, sizeof first, "%.50s", out);
    if (shell("glasspipe warp capture builtin:knot --color waves:9 --size 64x64 -q -o a.exr"))
        fail_msg("%s", err);
    assert_int_equal(
        shell("glasspipe warp a.exr --camera aside.json --unlit --size 64x64 -q -o a.png"), 0);
    if (strncmp(out, first, strlen(first)) != 0)
        fail_msg("%s is not %s", out, first);
    assert_int_equal(
        shell("glasspipe warp a.exr --truth a.exr --measure --method direct --json -q -o a.png"),
        0);
    json_t *object = parse_output();
    assert_true(json_real_value(json_object_get(object, "interior_psnr")) > 25);
    assert_true(json_real_value(json_object_get(object, "depth_error")) < 0.01);
    assert_true(json_integer_value(json_object_get(object, "width")) == 64);
    json_decref(object);
    static const char *const rows[][2] = {
        { "--measure", "a depth image has none: name it by --truth" },
        { "--source aside.json", "--source is of what is captured of a mesh" },
        { "--color gold", "--color is of what is captured of a mesh" },
        { "--kind cylinder", "--kind is of what is captured of a mesh" },
        { "--method polygons", "draws a mesh, and this is a depth image" },
        { "--method cylinder", "--method cylinder does not draw planar images" },
        { "--measure --truth a.exr --from 90 0", "from the eye of the view" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        char arguments[256];
        snprintf(arguments, sizeof arguments, "warp a.exr -o b.png %s", rows[i][0]);
        expect_refused(3, arguments, rows[i][1]);
    }
    if (shell("glasspipe warp capture builtin:knot --kind cylinder --size 32x32 -q -o b.exr"))
        fail_msg("%s", err);
    expect_refused(3, "warp b.exr --cut none -o b.png", "b.exr: --cut is of planar images");
    expect_refused(3, "warp b.exr --tolerance 2 -o b.png", "b.exr: --tolerance is of planar");
    write_file("broken.exr", "no picture");
    expect_refused(3, "warp broken.exr -o b.png", "broken.exr");
    expect_files("a.exr a.png aside.json b.exr broken.exr");
}

/* Another photograph of a room says how far off the first one is, moved to its place. */
static void a_photograph_is_moved_to_the_place_of_another(void **state)
{
    (void)state;
    unlink("scene.json");
    static const char *const frames[][2] = { { "00", "0" }, { "40", "40" } };
    for (size_t i = 0; i < GP_COUNT(frames); i++) {
        const int code =
            shell("export GLASSPIPE_DATA=${GLASSPIPE_DATA:-'%s/../../../shared/data'}; "
                  "glasspipe warp capture images/livingroom_%s_color.ppm --depth-file "
                  "images/livingroom_%s_depth.pgm --camera-file "
                  "images/livingroom_cameras.json --frame %s -q -o %s.exr",
                  man_pages, frames[i][0], frames[i][0], frames[i][1], frames[i][0]);
        if (code == 3 && strstr(err, "no such file")) {
            print_message("# skipped: the photographs are not here\n");
            return;
        }
        assert_int_equal(code, 0);
    }
    assert_int_equal(shell("glasspipe warp 00.exr --truth 40.exr --measure --json -q -o a.png"), 0);
    json_t *object = parse_output();
    assert_true(json_real_value(json_object_get(object, "depth_error")) < 0.003); /* metres */
    assert_true(json_real_value(json_object_get(object, "interior_psnr")) > 15);
    json_decref(object);
}

static void without_a_view_it_is_beside_the_source_and_says_so(void **state)
{
    (void)state;
    char first[256];
    unlink("scene.json");
    assert_int_equal(shell("glasspipe warp builtin:knot -q --size 64x64 -o a.png"), 0);
    expect_contains(out, "seen 12 degrees to the right of the source\n");
    snprintf(first, sizeof first, "%.46s", out);
    assert_int_equal(shell("glasspipe warp builtin:knot -q --size 64x64 -o a.png --turn 12"), 0);
    assert_true(strncmp(out, first, strlen(first)) == 0);
    assert_int_equal(shell("glasspipe warp builtin:knot -q --size 64x64 -o a.png --from 42 20"), 0);
    assert_null(strstr(out, "seen"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(wrong_arguments_are_usage_errors),
        PROGRAM_TEST(wrong_files_are_input_errors_of_one_line),
        PROGRAM_TEST(odd_places_and_sizes_are_drawn),
        PROGRAM_TEST(a_truth_has_the_colour_that_was_asked_for),
        PROGRAM_TEST(json_has_what_checks_ask_for),
        PROGRAM_TEST(options_of_one_method_mean_it),
        PROGRAM_TEST(small_relief_is_laid_over_all_kinds),
        PROGRAM_TEST(what_a_method_cannot_do_is_named),
        PROGRAM_TEST(stored_pictures_are_what_their_commands_draw),
        PROGRAM_TEST(images_of_files_are_those_that_were_captured),
        PROGRAM_TEST(a_photograph_is_moved_to_the_place_of_another),
        PROGRAM_TEST(without_a_view_it_is_beside_the_source_and_says_so),
    };
    return cmocka_run_group_tests_name("warp", tests, find_program, NULL);
}
