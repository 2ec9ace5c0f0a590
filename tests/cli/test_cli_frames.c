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

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_path_has_the_frames_up_to_its_last_key),
        PROGRAM_TEST(a_path_that_ends_before_frame_0_or_after_any_is_an_input_error),
        PROGRAM_TEST(frames_are_whole_numbers_within_their_limit),
        PROGRAM_TEST(windows_are_whole_numbers_inside_the_picture),
    };
    return cmocka_run_group_tests_name("frames", tests, find_program, NULL);
}
