/* glasspipe warp capture as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <math.h>

/* A lens whose middle is in column `cx`. */
static void write_lens(const char *name, const char *cx)
{
    char text[512];
    snprintf(text, sizeof text,
             "{ \"intrinsics\": { \"fx\": 2, \"fy\": 2, \"cx\": %s, \"cy\": 0 },\n"
             "  \"frames\": { \"7\": { \"camera_to_world\":\n"
             "    [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]] } } }\n",
             cx);
    write_file(name, text);
}

static void write_inputs(void)
{
    write_file("camera.json", "{ \"eye\": [0, 0, 5], \"at\": [0, 0, 0], \"fovy\": 40 }");
    write_lens("lens.json", "0.5");
    write_lens("aside.json", "9");
    write_file("color.ppm", "P6 2 1 255\nabcdef");
    write_file("depth.pgm", "P5 2 1 255\nab");
    write_file("small.pgm", "P5 1 1 255\na");
}

#define INPUTS "aside.json camera.json color.ppm depth.pgm lens.json"

/* --- what is refused -------------------------------------------------------------------------- */

static void wrong_arguments_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "", "expected a mesh, a scene or a picture" },
        { "a.ply b.ply", "b.ply" },
        { "a.ply -o a.png", "-o: expected a name that ends with .exr" },
        { "a.ply --kind ball", "--kind: expected planar, cylinder or box" },
        { "a.ply --layers 3", "--layers: expected a whole number from 1 to 2" },
        { "a.ply --rays faces", "--rays is for --kind cylinder" },
        { "a.ply --kind box --source a.json", "--source is for --kind planar" },
        { "a.ply --kind box --write-camera a.json", "--write-camera is for --kind planar" },
        { "a.ply --frame 3", "are for --depth-file" },
        { "a.ppm --depth-file b.pgm", "expected --camera-file with it" },
        { "a.ppm --depth-file b.pgm --camera-file c --relief 1", "--depth-file and --relief" },
        { "a.ppm --height-file b.pgm", "expected --relief with it" },
        { "a.ppm --relief 0", "--relief" },
        { "a.ppm --relief 1 --size 5x5", "--size is for meshes and scenes" },
        { "a.ppm --relief 1 --layers 1", "--layers is for meshes and scenes" },
        { "a.json --kind cylinder", "are for meshes" },
        { "a.json --up z", "are for meshes" },
        { "a.ply --up w", "--up: expected y, z, x, -y or -z" },
        { "a.ply --size 0x5", "--size" },
    };
    unlink("scene.json");
    expect_all_refused(2, "warp capture", wrong, GP_COUNT(wrong));
    expect_refused(2, "warp capture scene.json --width 3", "--width is for --relief");
    expect_refused(2, "warp capture builtin:cube --width 3", "--width is for --relief");
    expect_refused(2, "warp capture none.off --color nosuch", "--color: expected file, white");
    expect_refused(2, "warp capture none.off --color waves:x", "--color: expected a number");
    assert_int_equal(shell("mkdir d.exr"), 0);
    expect_refused(2, "warp capture none.off -o d.exr", "-o d.exr: is a directory");
    assert_int_equal(shell("rmdir d.exr"), 0);
    expect_files("");
}

static void wrong_files_are_input_errors_of_one_line(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "missing.ply", "missing.ply: no such file" },
        { "missing.json", "missing.json: no such file" },
        { "passes.json", "passes.json: a scene with passes of its own, which may look from "
                         "elsewhere: expected objects and lights under one camera" },
        { "builtin:nothing", "no builtin mesh 'nothing'" },
        { "builtin:ball --source missing.json", "missing.json" },
        { "color.ppm", "color.ppm: a picture: expected --depth-file or --relief with it" },
        { "picture.exr", "picture.exr: a picture: expected --depth-file or --relief with it" },
        { "color.ppm --depth-file missing.pgm --camera-file lens.json",
          "missing.pgm: no such file" },
        { "color.ppm --depth-file small.pgm --camera-file lens.json",
          "small.pgm: 1x1 pixels; color.ppm has 2x1" },
        { "color.ppm --depth-file depth.pgm --camera-file camera.json", "camera.json:1: " },
        { "color.ppm --depth-file depth.pgm --camera-file lens.json --frame 8", "frames.8" },
        { "missing.tga --relief 1", "missing.tga: no such file" },
        { "color.ppm --depth-file depth.pgm --camera-file aside.json --write-camera here.json",
          "--write-camera: no camera of a scene takes this" },
    };
    unlink("scene.json");
    write_file("passes.json", "{ \"passes\": [ { \"name\": \"a\" } ] }");
    write_inputs();
    expect_input_errors("warp capture -o a.exr", rows, GP_COUNT(rows));
    expect_files(INPUTS " passes.json small.pgm");
}

/* --- what is written -------------------------------------------------------------------------- */

static json_t *captured(const char *arguments)
{
    if (shell("glasspipe warp capture %s -q --json -o a.exr", arguments))
        fail_msg("%s: %s", arguments, err);
    return parse_output();
}

static void images_are_counted_and_kinds_told(void **state)
{
    (void)state;
    static const struct {
        const char *arguments;
        size_t images;
        const char *kind;
        int pixels, behind; /* at least, of the first */
    } rows[] = {
        { "builtin:knot --size 40x30", 1, "perspective plane", 100, 100 },
        { "builtin:knot --size 40x30 --layers 1", 1, "perspective plane", 100, 0 },
        { "builtin:knot --size 40x30 --color waves:3 --source camera.json", 1, "perspective plane",
          90, 90 },
        { "builtin:knot --size 40x30 --kind cylinder", 3, "cylinder", 500, 100 },
        { "builtin:knot --size 40x30 --kind cylinder --rays faces", 3, "cylinder", 500, 100 },
        { "builtin:knot --size 40x30 --kind box", 6, "parallel plane", 300, 300 },
        { "scene.json", 1, "perspective plane", 100, 0 },
        { "two.json --layers 2", 1, "perspective plane", 100, 20 },
        { "scene.json --size 20x20", 1, "perspective plane", 20, 0 },
        { "color.ppm --depth-file depth.pgm --camera-file lens.json", 1, "perspective plane", 2,
          0 },
        { "color.ppm --relief 0.1 --height-file depth.pgm --width 2", 1, "parallel plane", 2, 0 },
        { "depth.pgm --relief 0.1", 1, "parallel plane", 2, 0 },
    };
    write_file("two.json", "{ \"size\": [40, 30], \"objects\": [ { \"mesh\": \"builtin:quad\" },"
                           "{ \"mesh\": \"builtin:ball\", \"transform\": { \"scale\": 0.3 } } ] }");
    write_inputs();
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        json_t *object = captured(rows[i].arguments);
        const json_t *images = json_object_get(object, "images"),
                     *first = json_array_get(images, 0);
        assert_int_equal(json_array_size(images), rows[i].images);
        assert_string_equal(json_string_value(json_object_get(first, "kind")), rows[i].kind);
        const json_int_t pixels = json_integer_value(json_object_get(first, "pixels"));
        const json_int_t behind = json_integer_value(json_object_get(first, "behind"));
        if (pixels < rows[i].pixels || behind < rows[i].behind || (!rows[i].behind && behind))
            fail_msg("%s: %d and %d", rows[i].arguments, (int)pixels, (int)behind);
        json_decref(object);
        assert_int_equal(shell("glasspipe warp a.exr -q --size 40x30 -o a.png"), 0);
        expect_matches(out, "^hash A8R8G8B8 40x30 [0-9a-f]{16}\n");
    }
    expect_files("a.exr a.png aside.json camera.json color.ppm depth.pgm lens.json scene.json "
                 "small.pgm two.json");
}

/* Any device, any number of threads: the same file. */
static void files_are_the_same_bytes_however_they_are_made(void **state)
{
    (void)state;
    static const char *const ways[] = { "--executor reference", "--threads 1", "--threads 3" };
    unlink("scene.json");
    assert_int_equal(
        shell("glasspipe warp capture builtin:knot --size 30x20 --kind cylinder -q -o a.exr"), 0);
    for (size_t i = 0; i < GP_COUNT(ways); i++)
        if (shell("glasspipe warp capture builtin:knot --size 30x20 --kind cylinder -q -o b.exr %s "
                  "&& cmp a.exr b.exr",
                  ways[i]))
            fail_msg("%s: %s%s", ways[i], out, err);
    expect_files("a.exr b.exr");
}

/* The camera that is written sees what was captured: every pixel of it, and nearly no other. */
static void the_camera_that_is_written_sees_the_image_as_it_is(void **state)
{
    (void)state;
    assert_int_equal(
        shell("glasspipe warp capture scene.json -q -o a.exr --write-camera here.json"), 0);
    assert_int_equal(shell("glasspipe warp a.exr --camera here.json --size 64x48 --unlit -q --json "
                           "--measure --truth a.exr -o a.png"),
                     0);
    json_t *object = parse_output();
    assert_true(json_real_value(json_object_get(object, "depth_error")) < 1e-3);
    assert_true(json_real_value(json_object_get(object, "interior_psnr")) > 40);
    json_decref(object);
    expect_files("a.exr a.png here.json scene.json");
}

static void it_is_said_what_was_captured_and_where_it_went(void **state)
{
    (void)state;
    unlink("scene.json");
    assert_int_equal(shell("glasspipe warp capture builtin:ball --kind cylinder --size 16x16"), 0);
    expect_matches(
        out, "^hash DEPTH_IMAGE 16x16 [0-9a-f]{16}\n"
             "cylinder 16x16: [0-9]+ pixels, depth [0-9.e-]+ to [0-9.e-]+; behind them [0-9]+\n"
             "(parallel plane 8x8: [0-9]+ pixels, depth .*; behind them [0-9]+\n){2}$");
    assert_string_equal(err, "wrote ball.exr\n");
    expect_files("ball.exr");
    assert_int_equal(shell("glasspipe warp capture builtin:ball -q -o /nowhere/a.exr"), 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(wrong_arguments_are_usage_errors),
        PROGRAM_TEST(wrong_files_are_input_errors_of_one_line),
        PROGRAM_TEST(images_are_counted_and_kinds_told),
        PROGRAM_TEST(files_are_the_same_bytes_however_they_are_made),
        PROGRAM_TEST(the_camera_that_is_written_sees_the_image_as_it_is),
        PROGRAM_TEST(it_is_said_what_was_captured_and_where_it_went),
    };
    return cmocka_run_group_tests_name("warp capture", tests, find_program, NULL);
}
