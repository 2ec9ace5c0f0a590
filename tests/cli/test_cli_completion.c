/* The completion of bash, held against what the program says of itself. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

/* Fills `out` with what is offered after these words, the last of which is begun; a blank around
 * each. */
static void complete(const char *words)
{
    assert_int_equal(
        shell("bash -c '. \"%s/../completion/glasspipe.bash\"; COMP_WORDS=(\"%s\" %s); "
              "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _glasspipe; "
              "echo \" ${COMPREPLY[*]} \"'",
              man_pages, binary, words),
        0);
}

static void expect_offered(const char *words, const char *name)
{
    char word[64];
    snprintf(word, sizeof word, " %.48s ", name);
    if (!strstr(out, word))
        fail_msg("after '%s', %s is not offered:%s", words, name, out);
}

/* Long options of a text, each with a blank behind; returns how many. */
static int long_options(const char *text, char names[][48], int most)
{
    int count = 0;
    for (const char *at = strstr(text, "--"); at; at = strstr(at + 2, "--")) {
        const size_t length = 2 + strspn(at + 2, "abcdefghijklmnopqrstuvwxyz-");
        if (length == 2)
            continue;
        assert_true(count < most);
        snprintf(names[count++], sizeof names[0], "%.*s", (int)length, at);
    }
    return count;
}

static void commands_are_those_of_the_help(void **state)
{
    (void)state;
    static char help[sizeof out];
    int count = 0;
    assert_int_equal(shell("glasspipe --help"), 0);
    strcpy(help, out);
    complete("\"\"");
    char *line = strstr(help, "Commands:\n");
    assert_non_null(line);
    for (line = strchr(line, '\n') + 1; strncmp(line, "  ", 2) == 0;
         line = strchr(line, '\n') + 1) {
        char name[32];
        assert_int_equal(sscanf(line, " %31[a-z]", name), 1);
        expect_offered("", name);
        count++;
    }
    assert_true(count >= 9);
    complete("re");
    assert_string_equal(out, " render \n");
}

static void options_are_those_of_every_commands_help(void **state)
{
    (void)state;
    static const char *const commands[] = { "bench",   "chart",     "render",    "compare",
                                            "explain", "pixel",     "points",    "shader",
                                            "shadow",  "test",      "voxelize",  "volume",
                                            "warp",    "fragments", "warp walk", "warp capture",
                                            "inspect" };
    static char names[80][48];
    for (size_t c = 0; c < GP_COUNT(commands); c++) {
        char words[64];
        assert_int_equal(shell("glasspipe %s --help", commands[c]), 0);
        const int count = long_options(out, names, (int)GP_COUNT(names));
        snprintf(words, sizeof words, "%s --", commands[c]);
        complete(words);
        for (int i = 0; i < count; i++)
            expect_offered(words, names[i]);
    }
}

static void names_are_those_that_the_option_takes(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "shadow --method \"\"", " plain hardware \n" },
        { "shadow --fit \"\"", " light casters eye adaptive \n" },
        { "shadow --fit e", " eye \n" },
        { "shadow --map \"\"", "  \n" },
        { "voxelize --blend \"\"", " add or \n" },
        { "bench --table \"\"",
          " 2.1 2.2 4.1 4.2 3.1 3.2 003.3 003.1 003.2 003.4 001.1 001.2 002.1 002.2 002.3 \n" },
        { "volume --method \"\"", " raycast slices splat \n" },
        { "warp --kind \"\"", " planar cylinder box \n" },
        { "fragments --color \"\"", " normals material \n" },
        { "warp capture --rays \"\"", " columns faces \n" },
        { "volume --transfer sc", " scene.json \n" },
        { "render --isa \"\"", " auto sse2 avx2 avx512 neon \n" },
        { "render --executor \"\"", " fast reference \n" },
        { "shadow --curve sc", " scene.json \n" },
        { "render sc", " scene.json \n" },
        { "render --json sc", " scene.json \n" },
        { "render -o sc", " scene.json \n" },
        { "inspect --lesson sc", " scene.json \n" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        complete(rows[i][0]);
        if (strcmp(out, rows[i][1]) != 0)
            fail_msg("after '%s':%s", rows[i][0], out);
    }
}

static void settings_are_offered_behind_a_charts_technique(void **state)
{
    (void)state;
    complete("chart shadow --");
    expect_offered("chart shadow --", "--casters");
    expect_offered("chart shadow --", "--scaling");
    complete("chart shadow --method \"\"");
    expect_offered("chart shadow --method", "hardware");
    complete("chart voxelize --");
    assert_null(strstr(out, " --casters "));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(settings_are_offered_behind_a_charts_technique),
        PROGRAM_TEST(commands_are_those_of_the_help),
        PROGRAM_TEST(options_are_those_of_every_commands_help),
        PROGRAM_TEST(names_are_those_that_the_option_takes),
    };
    return cmocka_run_group_tests_name("completion", tests, find_program, NULL);
}
