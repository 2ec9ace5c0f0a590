/* glasspipe warp walk as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#define SMALL                                                                                      \
    "warp walk builtin:cube --objects 9 --frames 2 --pixels 24 --map 64 --size 64x36 -o a.png"

static void a_way_is_a_line_for_each_frame_and_a_sheet(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe " SMALL), 0);
    expect_matches(out, "^frame 0: [0-9]+ objects, [0-9]+ triangles, [0-9]+ of shadows, built in "
                        "[0-9.]+ ms, drawn in [0-9.]+ ms, hash [0-9a-f]{16}\nframe 1: 9 objects, "
                        ".*\n[0-9.]+ ms a frame, at most [0-9.]+\n$");
    expect_contains(err, "wrote a.png");
    assert_int_equal(shell("glasspipe compare a.png a.png"), 0);
}

static void flat_and_narrow_pictures_are_drawn(void **state)
{
    (void)state;
    static const char *const sizes[] = { "64x1", "1x64", "1x1" };
    for (size_t i = 0; i < GP_COUNT(sizes); i++)
        if (shell("glasspipe warp walk builtin:cube --objects 9 --frames 1 --pixels 24 --map 64 "
                  "--size %s -q -o a.png",
                  sizes[i]))
            fail_msg("%s: %s", sizes[i], err);
}

static void json_has_all_frames(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe " SMALL " --json --no-shadows -q"), 0);
    json_t *object = parse_output(), *frames = json_object_get(object, "frames");
    assert_int_equal(json_array_size(frames), 2);
    assert_true(json_number_value(json_object_get(object, "ms")) <=
                json_number_value(json_object_get(object, "most_ms")));
    const json_t *second = json_array_get(frames, 1);
    assert_int_equal(json_integer_value(json_object_get(second, "objects")), 9);
    assert_int_equal(json_integer_value(json_object_get(second, "shadow_triangles")), 0);
    json_decref(object);
}

static void what_is_wrong_is_refused(void **state)
{
    (void)state;
    expect_refused(3, "warp walk nowhere.off", "nowhere.off");
    expect_refused(3, "warp walk builtin:cat", "no builtin mesh 'cat'");
    expect_refused(2, "warp walk --objects 0", "--objects");
    expect_refused(2, "warp walk --frames 2000", "--frames");
    expect_refused(2, "warp walk --size 0x10 --frames 1 --objects 1 --pixels 8", "each from 1 to");
    expect_refused(2, "warp walk --size 16x0 --frames 1 --objects 1 --pixels 8", "not '16x0'");
    expect_refused(2, "warp walk -o a.txt", "-o ");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_way_is_a_line_for_each_frame_and_a_sheet),
        PROGRAM_TEST(flat_and_narrow_pictures_are_drawn),
        PROGRAM_TEST(json_has_all_frames),
        PROGRAM_TEST(what_is_wrong_is_refused),
    };
    return cmocka_run_group_tests_name("warp walk", tests, find_program, NULL);
}
