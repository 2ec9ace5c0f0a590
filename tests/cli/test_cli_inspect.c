/* glasspipe inspect: what it writes and what it refuses. What the page shows is looked at in a
 * browser, by tests/tools/inspect_pages.py. */
#include "tests/support/program.h"

static char page[1 << 24], again[1 << 24];

#define INSPECT "glasspipe inspect scene.json -q --no-timings --pixels 40 "

static void a_page_holds_all_that_it_needs(void **state)
{
    (void)state;
    assert_int_equal(shell(INSPECT "-o page.html"), 0);
    expect_files("page.html scene.json");
    assert_true(read_file("page.html", page, sizeof page) > 100000);
    expect_contains(page, "<!DOCTYPE html>");
    expect_contains(page, "\"page/main.js\":\"data:text/javascript;base64,");
    expect_contains(page, "id=\"blob-0\"");
    assert_null(strstr(page, "src=\"http"));
    assert_null(strstr(page, "href=\"http"));
    assert_null(strstr(page, "@import"));
    assert_null(strstr(page, "id=\"timings\""));
}

static void
a_page_has_the_same_bytes_for_any_threads_and_times_only_where_they_are_wanted(void **state)
{
    (void)state;
    assert_int_equal(shell(INSPECT "-o one.html --threads 1"), 0);
    assert_int_equal(shell(INSPECT "-o three.html --threads 3"), 0);
    read_file("one.html", page, sizeof page);
    read_file("three.html", again, sizeof again);
    assert_string_equal(page, again);
    assert_int_equal(shell("glasspipe inspect scene.json -q --pixels 40 -o timed.html"), 0);
    read_file("timed.html", page, sizeof page);
    expect_contains(page, "id=\"timings\"");
}

static void a_region_makes_a_page_larger_and_json_tells_its_bytes(void **state)
{
    (void)state;
    assert_int_equal(shell(INSPECT "-o plain.html --json"), 0);
    json_t *plain = parse_output();
    assert_int_equal(shell(INSPECT "-o region.html --json --region 24 16 16 16"), 0);
    json_t *region = parse_output();
    assert_true(json_integer_value(json_object_get(region, "bytes")) >
                json_integer_value(json_object_get(plain, "bytes")) + 1000);
    assert_int_equal(read_file("plain.html", page, sizeof page),
                     json_integer_value(json_object_get(plain, "bytes")));
    json_decref(plain);
    json_decref(region);
}

static void techniques_have_their_options_and_frames_are_compared(void **state)
{
    (void)state;
    assert_int_equal(shell(INSPECT "-o plain.html --technique shadow --map 64 --method plain"), 0);
    assert_int_equal(
        shell(INSPECT "-o two.html --technique shadow --map 64 --against '--method hardware'"), 0);
    read_file("two.html", page, sizeof page);
    assert_null(strstr(page, ", -1, -1);</script>")); /* a second frame is there */
    read_file("plain.html", page, sizeof page);
    expect_contains(page, ", -1, -1);</script>");
}

#define LESSON(rest)                                                                               \
    "{\"title\": \"T\", \"learn\": \"L\", \"unit\": \"clipping\", \"question\": \"Q\", \"why\": "  \
    "\"WHY?\",\n"                                                                                  \
    "\"pixel\": [32, 24], " rest "}\n"

static void a_lesson_has_its_question_and_neither_answer_nor_reason_in_clear(void **state)
{
    (void)state;
    write_file("scene.lesson.json",
               LESSON("\"answer\": {\"from\": \"clip.corners\", \"form\": \"whole\"}"));
    assert_int_equal(
        shell("glasspipe inspect --lesson scene.lesson.json -q --no-timings -o a.html"), 0);
    read_file("a.html", page, sizeof page);
    assert_null(strstr(page, ", -1);</script>"));
    assert_null(strstr(page, "WHY?"));
    expect_contains(page, "<title>T - glasspipe inspect</title>");
    assert_int_equal(shell("glasspipe inspect --lesson . --json --no-timings -o course"), 0);
    json_t *told = parse_output();
    assert_string_equal(json_string_value(json_object_get(told, "index")), "course/index.html");
    assert_int_equal(json_integer_value(json_object_get(told, "lessons")), 1);
    json_decref(told);
    assert_int_equal(shell("ls course"), 0);
    assert_string_equal(out, "index.html\nscene.html\n");
    read_file("course/index.html", page, sizeof page);
    expect_contains(page, "href=\"scene.html\"");
}

static void a_lesson_that_asks_for_nothing_is_refused(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { LESSON("\"answer\": {\"from\": \"clip.nothing\", \"form\": \"whole\"}"), "clip.nothing" },
        { LESSON("\"answer\": {\"from\": \"clip.corners\", \"form\": \"odd\"}"), "answer.form" },
        { LESSON("\"answer\": {\"from\": \"clip.corners\", \"form\": \"choice\"}"), "answer" },
        { LESSON("\"triangle\": 99, \"answer\": {\"from\": \"clip.corners\"}"), "no fragment" },
        { LESSON("\"pass\": 3, \"answer\": {\"from\": \"clip.corners\"}"), "no pass 3" },
        { LESSON("\"ask\": 1, \"answer\": {\"from\": \"clip.corners\"}"),
          "scene.lesson.json:2: ask" },
        { LESSON("\"hint\": \"H\""), "answer" },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        write_file("scene.lesson.json", rows[i][0]);
        expect_refused(3, "inspect --lesson scene.lesson.json -q -o page.html", rows[i][1]);
    }
    expect_files("scene.json scene.lesson.json");
}

/* The fast executor, which a page is held against, is that of the instruction set. */
static void an_instruction_set_that_is_not_here_is_refused(void **state)
{
    (void)state;
    static const char *const names[] = { "sse2", "avx2", "avx512", "neon" };
    int refused = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const int code = shell("glasspipe render scene.json -q -o a.ppm --isa %s", names[i]);
        assert_int_equal(shell(INSPECT "-o a.html --isa %s", names[i]), code);
        refused += code == 2;
        if (code)
            continue;
        assert_int_equal(
            shell("glasspipe inspect scene.json -q --pixels 40 -o a.html --isa %s", names[i]), 0);
        char words[32];
        snprintf(words, sizeof words, "\"isa\":\"%s\"", names[i]);
        read_file("a.html", page, sizeof page);
        expect_contains(page, words);
    }
    assert_true(refused > 0); /* no machine has all */
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    expect_refused(2, "inspect", "a scene file");
    expect_refused(2, "inspect scene.json --lesson scene.lesson.json", "expected no other");
    expect_refused(2, "inspect --lesson scene.lesson.json --technique shadow", "--technique");
    expect_refused(3, "inspect --lesson scene.json", "NAME.lesson.json");
    expect_refused(3, "inspect --lesson nope.lesson.json", "nope.lesson.json");
    expect_refused(3, "inspect --lesson .", "there is no NAME.lesson.json");
    expect_refused(2, "inspect scene.json --technique nope", "--technique nope");
    expect_refused(2, "inspect scene.json --method plain", "--method");
    expect_refused(2, "inspect scene.json --against '--map 64'", "--technique");
    expect_refused(2, "inspect scene.json --technique shadow --against '--nope 1'", "--against");
    expect_refused(2, "inspect scene.json --truth", "--truth");
    expect_refused(3, "inspect nope.json", "nope.json");
    expect_refused(4, "inspect scene.json -q --pixels 1 -o nope/page.html", "nope/page.html");
    expect_refused(2, "inspect scene.json -o .", "-o .: expected the name of a file");
    expect_refused(2, "inspect scene.json -o ''", "-o : expected the name of a file");
    expect_refused(2, "inspect --lesson scene.lesson.json -o .", "-o .: expected the name");
    expect_refused(2, "inspect scene.json --techn shadow", "--technique is to be written out");
    expect_refused(2, "inspect scene.json --technique shadow --technique warp", "to name one");
    expect_refused(2, "inspect scene.json --region 100 100 5 5", "no pass draws there");
    expect_refused(2, "inspect scene.json --region 64 0 5 5", "no pass draws there");
    expect_refused(2, "inspect scene.json --region 1.5 1 5 5", "whole numbers, not '1.5'");
    expect_refused(2, "inspect scene.json --region 1 1 5 0", "a width and a height from 1");
    expect_refused(2, "inspect scene.json --draw 1", "--draw 1: the last pass has 1 draw");
    expect_refused(2, "inspect scene.json --technique shadow --draw 999", "--draw 999: the last");
    expect_refused(3, "inspect nope.json --technique shadow", "glasspipe: nope.json: ");
    assert_null(strstr(err, "nope.json: nope.json"));
    expect_files("scene.json");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_page_holds_all_that_it_needs),
        PROGRAM_TEST(
            a_page_has_the_same_bytes_for_any_threads_and_times_only_where_they_are_wanted),
        PROGRAM_TEST(a_region_makes_a_page_larger_and_json_tells_its_bytes),
        PROGRAM_TEST(techniques_have_their_options_and_frames_are_compared),
        PROGRAM_TEST(a_lesson_has_its_question_and_neither_answer_nor_reason_in_clear),
        PROGRAM_TEST(a_lesson_that_asks_for_nothing_is_refused),
        PROGRAM_TEST(an_instruction_set_that_is_not_here_is_refused),
        PROGRAM_TEST(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests_name("inspect", tests, find_program, NULL);
}
