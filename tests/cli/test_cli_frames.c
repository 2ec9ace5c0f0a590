/* Frames and windows of glasspipe render as their user meets them. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

/* --- frames ----------------------------------------------------------------------------------- */

static void a_path_has_the_frames_up_to_its_last_key(void **state)
{
    (void)state;
    write_file("p.json", "{ \"rate\": 10, \"keys\": [ { \"time\": -1 }, { \"time\": 0.2 } ] }");
    assert_int_equal(shell("glasspipe render -q scene.json --size 8x8 --path p.json -o 'a#.ppm'"),
                     0);
    expect_matches(out, "^frame 0: hash .*\nframe 1: hash .*\nframe 2: hash [^\n]*\n$");
    expect_files("a0.ppm a1.ppm a2.ppm p.json scene.json");
    write_file("p.json", "{ \"keys\": [ { \"time\": 0 } ] }");
    assert_int_equal(shell("glasspipe render -q scene.json --size 8x8 --path p.json -o 'b#.ppm'"),
                     0);
    expect_matches(out, "^frame 0: hash [^\n]*\n$");
}

static void a_path_that_ends_before_frame_0_or_after_any_is_an_input_error(void **state)
{
    (void)state;
    static const struct {
        const char *path, *part;
    } wrong[] = {
        { "{ \"keys\": [ { \"time\": -0.08 } ] }", "p.json: keys[0].time: -0.08, the last" },
        { "{ \"keys\": [ { \"time\": -9 }, { \"time\": -5 } ] }", "keys[1].time: -5, the last" },
        { "{ \"rate\": 1e6, \"keys\": [ { \"time\": 1e6 } ] }", "more than frame 10000000" },
        { "{ \"rate\": 1e6, \"keys\": [ { \"time\": 10.000001 } ] }", "more than frame 10000000" },
    };
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        write_file("p.json", wrong[i].path);
        expect_refused(3, "render scene.json --path p.json -o 'y#.png'", wrong[i].part);
    }
    /* where the frames are named, the last key is not asked */
    assert_int_equal(
        shell("glasspipe render -q scene.json --size 8x8 --path p.json --frames 7:7 -o 'y#.ppm'"),
        0);
    expect_files("p.json scene.json y7.ppm");
}

static void frames_are_whole_numbers_within_their_limit(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "--frames 4294967296:4294967297", "4294967296:4294967297" },
        { "--frames 0:4294967297", "both at most 10000000" },
        { "--frames 0:20000000", "both at most 10000000" },
        { "--frames 2:1", "A not above B" },
        { "--frames 0:1:0", "--frames" },
        { "--frames 0:1:", "--frames" },
        { "--frames ' 0:1'", "--frames" },
        { "--frames 0:+1", "--frames" },
        { "--frames -1:1", "--frames" },
        { "--frames 0:1:4294967297", "--frames" },
        { "--frames 0:1x", "--frames" },
        { "--frames 5", "--frames" },
    };
    expect_all_refused(2, "render scene.json --turn 4 -o 'y#.ppm'", wrong, GP_COUNT(wrong));
    expect_files("scene.json");
    assert_int_equal(shell("glasspipe render -q scene.json --size 8x8 --turn 9 --frames 1:6:3 -o "
                           "'y##.ppm'"),
                     0);
    expect_matches(out, "^frame 1: hash [^\n]*\nframe 4: hash [^\n]*\n$");
    expect_files("scene.json y01.ppm y04.ppm");
}

/* --- windows ---------------------------------------------------------------------------------- */

static void windows_are_whole_numbers_inside_the_picture(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "--window 4294967296,0,16x16", "expected X,Y,WxH" },
        { "--window '0,0,16x16 of 4294967312x16'", "expected X,Y,WxH" },
        { "--window '0,0,16x16 of 100000x16'", "a whole of 100000x16" },
        { "--window '0,0,16x16 of 0x16'", "a whole of 0x16" },
        { "--window ' 1,2,16x16'", "expected X,Y,WxH" },
        { "--window ' +1,2,16x16'", "expected X,Y,WxH" },
        { "--window 1,2,16x16x", "expected X,Y,WxH" },
        { "--window '1,2,16x16 of'", "expected X,Y,WxH" },
        { "--window '1,2,16x16 of 64'", "expected X,Y,WxH" },
        { "--window 0,0,0x16", "is not inside 64x48" },
        { "--window 49,0,16x16", "49,0,16x16 is not inside 64x48" },
        { "--window 0,33,16x16", "is not inside 64x48" },
        { "--window 2147483647,0,2147483647x1", "is not inside 64x48" },
    };
    expect_all_refused(2, "render scene.json -o a.ppm", wrong, GP_COUNT(wrong));
    expect_files("scene.json");
    assert_int_equal(shell("glasspipe render -q scene.json --window 48,32,16x16 -o a.ppm"), 0);
    expect_matches(out, "^hash [^\n]* 16x16 [0-9a-f]{16}\n$");
}

/* --- what goes together ----------------------------------------------------------------------- */

static void options_of_other_work_are_refused(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "scene.json --verify 100", "are of frames and windows" },
        { "scene.json --timeout 1e-7", "are of frames and windows" },
        { "scene.json --resume --size 8x8", "are of frames and windows" },
        { "scene.json --list-passes --dump nosuch", "--list-passes draws nothing" },
        { "scene.json --list-passes -o a.png", "--list-passes draws nothing" },
        { "--schema -o a.png", "--schema draws nothing" },
        { "--schema --turn 4", "--schema draws nothing" },
        { "scene.json --size 32x32 --window '0,0,8x8 of 64x64'", "--size: --window says" },
    };
    expect_all_refused(2, "render", wrong, GP_COUNT(wrong));
    assert_int_equal(
        shell("glasspipe render -q scene.json --size 32x32 --window 0,0,8x8 --verify 100 "
              "--resume -o a.ppm"),
        0);
    assert_int_equal(shell("glasspipe render --schema --json"), 0);
    expect_files("a.ppm scene.json");
}

/* --- names ------------------------------------------------------------------------------------ */

/* Names of files are any bytes; what is printed and written is UTF-8. */
static void names_that_are_no_utf_8_are_told_with_what_stands_for_it(void **state)
{
    (void)state;
    static const struct {
        const char *line, *part;
        int code;
    } rows[] = {
        { "render scene.json --turn 2 -o $(printf 'q\\376#.ppm') --size 8x8",
          "\"file\": \"q\xef\xbf\xbd"
          "0.ppm\"",
          0 },
        { "render scene.json -o $(printf 'q\\376.ppm') --size 8x8",
          "\"file\": \"q\xef\xbf\xbd.ppm\"", 0 },
        { "test $(printf 'p\\377')", "\"folder\": \"p\xef\xbf\xbd\"", 1 },
        { "warp capture builtin:cube --size 16x16 -o $(printf 'c\\376.exr')",
          "\"file\": \"c\xef\xbf\xbd.exr\"", 0 },
        { "inspect $(printf 'p\\377/c\\376.json') -o $(printf 'c\\376.html')",
          "\"page\": \"c\xef\xbf\xbd.html\"", 0 },
    };
    assert_int_equal(shell("d=$(printf 'p\\377'); mkdir \"$d\"; sed 's/64, 48/8, 8/' scene.json "
                           ">\"$d/$(printf 'c\\376').json\""),
                     0);
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const int code = shell("glasspipe %s --json -q", rows[i].line);
        if (code != rows[i].code)
            fail_msg("%s: %d\n%s", rows[i].line, code, err);
        json_decref(parse_output());
        expect_contains(out, rows[i].part);
    }
    expect_contains((read_file("c\376.html", out, sizeof out), out),
                    "<title>c\xef\xbf\xbd - glasspipe inspect</title>");
    assert_int_equal(shell("glasspipe test $(printf 'p\\377') --junit j.xml"), 1);
    read_file("j.xml", out, sizeof out);
    expect_contains(out, "classname=\"p\xef\xbf\xbd\" name=\"c\xef\xbf\xbd\"");
    assert_int_equal(shell("a=$(printf 'q\\376.ppm'); cp $a b.ppm; glasspipe compare $a b.ppm "
                           "--report r.html"),
                     0);
    read_file("r.html", out, sizeof out);
    expect_contains(out, "q\xef\xbf\xbd.ppm against b.ppm");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_path_has_the_frames_up_to_its_last_key),
        PROGRAM_TEST(a_path_that_ends_before_frame_0_or_after_any_is_an_input_error),
        PROGRAM_TEST(frames_are_whole_numbers_within_their_limit),
        PROGRAM_TEST(options_of_other_work_are_refused),
        PROGRAM_TEST(names_that_are_no_utf_8_are_told_with_what_stands_for_it),
        PROGRAM_TEST(windows_are_whole_numbers_inside_the_picture),
    };
    return cmocka_run_group_tests_name("frames", tests, find_program, NULL);
}
