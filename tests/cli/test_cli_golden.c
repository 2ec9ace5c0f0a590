/* `glasspipe test` as its user meets it, and the page that tells of it. */
#include "pipeline/base/base.h"
#include "tests/support/markup.h"
#include "tests/support/program.h"

#include <sys/resource.h>

/* A folder "set" with scenes that are drawn in different colours. */
static void make_scenes(int count)
{
    assert_int_equal(shell("mkdir set"), 0);
    for (int i = 0; i < count; i++) {
        char path[64], text[sizeof scene];
        snprintf(path, sizeof path, "set/s%02d.json", i);
        strcpy(text, scene);
        char digits[16];
        snprintf(digits, sizeof digits, "%02d", i);
        memcpy(strstr(text, "0.25, 0.5") + 2, digits, 2); /* the background's red */
        write_file(path, text);
    }
}

static void bless(const char *name)
{
    if (shell("glasspipe test set --bless %s", name) != 0)
        fail_msg("%s", err);
}

/* Puts the stored hash of a scene to one that no picture has. */
static void spoil_hash(const char *name)
{
    assert_int_equal(shell("sed -i 's/[0-9a-f]*$/0123456789abcdef/' set/%s.hash", name), 0);
}

static void blessed_scenes_pass_and_their_files_are_what_render_gives(void **state)
{
    (void)state;
    make_scenes(2);
    assert_int_equal(shell("glasspipe test set --bless s00"), 0);
    assert_string_equal(out, "set/s00.png\nset/s00.hash\n");
    assert_int_equal(shell("glasspipe render -q set/s00.json -o a.png | cmp - set/s00.hash && "
                           "cmp a.png set/s00.png"),
                     0);
    assert_int_equal(shell("glasspipe test set"), 1);
    expect_contains(out, "missing  s01  nothing is stored; --bless s01 stores it\n");
    expect_contains(out, "1 of 2 scenes as stored, 1 missing; ");
    bless("s01");
    assert_int_equal(shell("glasspipe test set"), 0);
    expect_matches(out, "^2 of 2 scenes as stored; [0-9.]+ s\n$");
    assert_string_equal(err, "");
    assert_int_equal(shell("glasspipe test set -v"), 0);
    expect_contains(out, "same     s00\nsame     s01\n2 of 2");
    assert_int_equal(shell("glasspipe test set s01 -v"), 0);
    assert_int_equal(markup_count(out, "same"), 1);
}

static void each_way_to_fail_has_its_state_and_stops_no_other(void **state)
{
    (void)state;
    make_scenes(6);
    for (int i = 0; i < 5; i++) {
        char name[16];
        snprintf(name, sizeof name, "s%02d", i);
        bless(name);
    }
    spoil_hash("s01");
    assert_int_equal(shell("cp set/s03.png set/s02.png; rm set/s02.hash"), 0);
    assert_int_equal(shell("glasspipe test set --junit j.xml"), 1);
    expect_matches(out, "differs  s01  hash A8R8G8B8 64x48 [0-9a-f]{16}, stored is A8R8G8B8 64x48 "
                        "0123456789abcdef; s01.png: same bits in all 64x48 pixels\n");
    expect_matches(out, "differs  s02  s02.png: different: [0-9]+ of 3072 pixels");
    expect_contains(out, "3 of 6 scenes as stored, 2 differ, 1 missing; ");
    write_file("set/s03.json", "{ \"objects\": [ 3 ] }\n");
    write_file("set/s04.hash", "0123\n");
    assert_int_equal(shell("rm set/s00.json; glasspipe test set --junit j.xml"), 3);
    expect_contains(out, "broken   s00  set/s00.json: ");
    expect_contains(out, "broken   s03  set/s03.json:1: objects[0]");
    expect_contains(out, "broken   s04  set/s04.hash: expected a line 'hash FORMAT WxH NUMBER'");
    expect_contains(out, "0 of 6 scenes as stored, 2 differ, 1 missing, 3 broken; ");
    static char xml[sizeof out];
    read_file("j.xml", xml, sizeof xml);
    char *begin = strstr(xml, "?>");
    assert_non_null(begin);
    markup_check(begin + 3);
    assert_int_equal(markup_count(xml, "<testcase classname=\"set\" name=\"s0"), 6);
    assert_int_equal(markup_count(xml, "<failure type=\"differs\""), 2);
    assert_int_equal(markup_count(xml, "<failure type=\"missing\""), 1);
    assert_int_equal(markup_count(xml, "<error type=\"broken\""), 3);
    expect_contains(xml, "tests=\"6\" failures=\"3\" errors=\"3\"");
    assert_int_equal(shell("glasspipe test set --json --threads 3"), 3);
    json_t *object = parse_output();
    assert_int_equal(json_integer_value(json_object_get(object, "broken")), 3);
    assert_int_equal(json_array_size(json_object_get(object, "results")), 6);
    json_decref(object);
}

static void pictures_hold_within_the_limits_of_the_command_and_of_the_scene(void **state)
{
    (void)state;
    make_scenes(26);
    static const char *const extensions[] = { "png", "ppm", "pfm" };
    for (size_t i = 0; i < GP_COUNT(extensions); i++) {
        assert_int_equal(shell("rm -f set/s2*; cp %s set/s20.json; "
                               "glasspipe render -q scene.json -o set/s20.%s >h",
                               "scene.json", extensions[i]),
                         0);
        assert_int_equal(shell("glasspipe test set s20"), 0);
    }
    /* 0.20 against 0.21 of red behind: two or three codes of 255 */
    assert_int_equal(shell("rm -f set/*; sed 's/0\\.25/0.20/' scene.json >set/a.json; "
                           "sed 's/0\\.25/0.21/' scene.json >b.json; "
                           "glasspipe render -q b.json -o set/a.png"),
                     0);
    assert_int_equal(shell("glasspipe test set"), 1);
    assert_int_equal(shell("glasspipe test set --fail 0.02 -v"), 0);
    expect_contains(out, "same     a  a.png: within the limits: ");
    write_file("set/a.limits", "--fail 0.02\n");
    assert_int_equal(shell("glasspipe test set"), 0);
    write_file("set/a.limits", "--fail 0.001 --failpercent 1\n");
    assert_int_equal(shell("glasspipe test set --fail 0.02"), 1);
    expect_contains(out, "differ by more than 0.001; 1 % may");
    write_file("set/a.limits", "--fail 1\n--hardfail 0.001\n");
    assert_int_equal(shell("glasspipe test set"), 3);
    expect_contains(out, "set/a.limits: expected one line of text");
    write_file("set/a.limits", "--fail 1\r\n \n\n");
    assert_int_equal(shell("glasspipe test set"), 0);
    write_file("set/a.limits", "--fial 0.1\n");
    assert_int_equal(shell("glasspipe test set"), 3);
    expect_contains(out, "set/a.limits: no option '--fial'");
    bless("a"); /* what is stored is a picture, and stays one */
    assert_int_equal(shell("rm set/a.limits; glasspipe test set && ls set"), 0);
    expect_contains(out, "\na.json\na.png\n");
    assert_int_equal(shell("glasspipe test set --size 32x24"), 1);
    expect_contains(out, "a.png: different sizes: 64x48 and 32x24");
}

static void reports_show_what_differs(void **state)
{
    (void)state;
    static char page[sizeof out];
    make_scenes(3);
    bless("s00"), bless("s01");
    assert_int_equal(shell("cp set/s02.json set/s01.json; glasspipe test set --report r"), 1);
    assert_int_equal(shell("ls r"), 0);
    assert_string_equal(out, "s01.html\ns01.png\ns02.png\n");
    read_file("r/s01.html", page, sizeof page);
    markup_check(page);
    expect_contains(page, "s01.png against s01 as drawn");
    assert_int_equal(shell("glasspipe render -q set/s01.json -o a.png && cmp a.png r/s01.png"), 0);
}

static void wrong_uses_have_their_codes(void **state)
{
    (void)state;
    expect_refused(2, "test", "expected a folder of scenes");
    expect_refused(2, "test . --bless scene --junit x.xml", "--bless stores one scene");
    static const char *const tests[] = { "--json", "--resume", "--verify 5", "--timeout 1" };
    for (size_t i = 0; i < GP_COUNT(tests); i++) {
        char arguments[64];
        snprintf(arguments, sizeof arguments, "test . --bless scene %s", tests[i]);
        expect_refused(2, arguments, "--json, --resume, --verify and --timeout are of tests");
    }
    expect_refused(2, "test . --bless scene --fail 0.1", "--bless stores one scene");
    expect_refused(2, "test . --fail x", "--fail");
    expect_refused(3, "test nowhere", "nowhere: No such file");
    expect_refused(3, "test . nothing", ".: no scene nothing.json");
    expect_refused(3, "test . --bless nothing", "nothing.json");
    assert_int_equal(shell("mkdir empty"), 0);
    expect_refused(3, "test empty", "empty: no scene *.json");
    expect_files("empty scene.json");
}

static void what_cannot_be_written_has_its_code(void **state)
{
    (void)state;
    make_scenes(2);
    assert_int_equal(shell("mkdir set/s00.hash"), 0);
    assert_int_equal(shell("glasspipe test set --bless s00"), 4);
    expect_contains(err, "set/s00.hash: ");
    assert_int_equal(shell("rmdir set/s00.hash && glasspipe test set --bless s00"), 0);
    assert_int_equal(shell("mkdir -p r/s01.png && glasspipe test set --report r"), 4);
    expect_contains(out, "broken   s01  r/s01.png: ");
    expect_contains(out, "1 of 2 scenes as stored, 1 broken");
    assert_int_equal(shell("glasspipe test set s00 --report set/s00.json"), 4);
    expect_contains(err, "set/s00.json: Not a directory");
    assert_int_equal(shell("glasspipe test set s00 --report no/where"), 4);
}

/* What was found by other limits, or against other pictures, is not what is asked for. The slow
 * scene takes longer than it may. */
static void a_journal_is_of_what_is_asked_for(void **state)
{
    (void)state;
    static const char line[] = "glasspipe test set --executor reference --threads 2 --timeout 1 "
                               "--resume";
    static const char *const others[] = {
        "--fail 1",   "--fail 1 --failpercent 50", "--flipfail 0", "--ppd 60", "--no-alpha",
        "--report r",
    };
    static const char *const files[] = { "s00.limits", "s00.hash", "s00.png", "s01.exr" };
    make_scenes(2);
    bless("s00");
    assert_int_equal(shell("sed 's/64, 48/6144, 6144/' scene.json >set/slow.json"), 0);
    assert_int_equal(shell("%s", line), 4);
    expect_contains(err, "slow: thread ");
    for (size_t i = 0; i < GP_COUNT(others); i++) {
        assert_int_equal(shell("%s %s", line, others[i]), 3);
        expect_contains(err, "glasspipe-test.journal: of other work");
    }
    for (size_t i = 0; i < GP_COUNT(files); i++) {
        assert_int_equal(shell("touch set/%s && cp set/%s kept && echo >>set/%s && %s", files[i],
                               files[i], files[i], line),
                         3);
        expect_contains(err, "glasspipe-test.journal: of other work");
        assert_int_equal(
            shell("mv kept set/%s && test -s set/%s || rm set/%s", files[i], files[i], files[i]),
            0);
    }
    assert_int_equal(shell("%s", line), 4);
}

/* A terminal of util-linux's `script`, which runs a line on it. */
static void progress_is_shown_on_a_terminal_alone_and_after_a_second(void **state)
{
    (void)state;
    make_scenes(2);
    assert_int_equal(shell("glasspipe test set 2>messages; test ! -s messages"), 0);
    if (shell("command -v script") != 0) {
        print_message("# skipped: no script (bsdutils)\n");
        skip();
    }
    static const struct {
        const char *term, *options;
        bool shown;
    } rows[] = {
        { "xterm", "", false }, /* a moment */
        { "xterm", "--executor reference --threads 1 --size 6144x6144", true },
        { "dumb", "--executor reference --threads 1 --size 6144x6144", false },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        assert_int_equal(
            shell("TERM=%s script -qec \"'%s' test set %s\" typescript >screen </dev/null",
                  rows[i].term, binary, rows[i].options),
            1);
        read_file("screen", out, sizeof out);
        assert_true((strstr(out, "\r\033[K2/2 ") != NULL) == rows[i].shown);
        assert_null(strstr(out, "2 of 2\r"));
    }
}

static void a_hundred_small_scenes_take_a_moment(void **state)
{
    (void)state;
    struct rusage before, after;
    make_scenes(10);
    for (int i = 0; i < 10; i++) {
        char name[16];
        snprintf(name, sizeof name, "s%02d", i);
        bless(name);
        assert_int_equal(shell("for d in 1 2 3 4 5 6 7 8 9; do for e in json hash png; do "
                               "cp set/s0%d.$e set/s${d}%d.$e; done; done",
                               i, i),
                         0);
    }
    getrusage(RUSAGE_CHILDREN, &before);
    assert_int_equal(shell("glasspipe test set"), 0);
    getrusage(RUSAGE_CHILDREN, &after);
    expect_contains(out, "100 of 100 scenes as stored");
    /* processor time, which others at work do not change: five seconds of two */
    const long used = after.ru_utime.tv_sec - before.ru_utime.tv_sec + after.ru_stime.tv_sec -
                      before.ru_stime.tv_sec;
    if (!getenv("EMULATOR") && used >= 10)
        fail_msg("%ld s of processor time", used);
}

/* --- the page --------------------------------------------------------------------------------- */

/* Runs every block of shell of GOLDEN_PICTURES.md, but the one that installs packages, in one
 * shell. */
static void the_pages_example_runs_as_it_is_printed(void **state)
{
    (void)state;
    char page[PATH_MAX + 64];
    snprintf(page, sizeof page, "%s/../../GOLDEN_PICTURES.md", man_pages);
    assert_int_equal(shell("awk '/^```sh/ { inside = 1; next } /^```/ { inside = 0 } inside' '%s' |"
                           " sed '/^# build server/,$d' >page.sh; test -s page.sh",
                           page),
                     0);
    assert_int_equal(shell("set -e; . ./page.sh"), 0);
    assert_int_equal(markup_count(out, "1 of 1 scenes as stored"), 4);
    assert_int_equal(markup_count(out, "0 of 1 scenes as stored, 1 differ"), 1);
    expect_contains(out, "exit code 1\n");
    expect_files("differing page.sh pictures results.xml scene.json");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(blessed_scenes_pass_and_their_files_are_what_render_gives),
        PROGRAM_TEST(each_way_to_fail_has_its_state_and_stops_no_other),
        PROGRAM_TEST(pictures_hold_within_the_limits_of_the_command_and_of_the_scene),
        PROGRAM_TEST(reports_show_what_differs),
        PROGRAM_TEST(wrong_uses_have_their_codes),
        PROGRAM_TEST(what_cannot_be_written_has_its_code),
        PROGRAM_TEST(a_journal_is_of_what_is_asked_for),
        PROGRAM_TEST(progress_is_shown_on_a_terminal_alone_and_after_a_second),
        PROGRAM_TEST(a_hundred_small_scenes_take_a_moment),
        PROGRAM_TEST(the_pages_example_runs_as_it_is_printed),
    };
    return cmocka_run_group_tests_name("golden", tests, find_program, NULL);
}
