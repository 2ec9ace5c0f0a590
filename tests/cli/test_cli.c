/* The program as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/limited.h"
#include "tests/support/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>

static const char *const commands[] = { "bench",   "chart",     "render",    "compare",
                                        "explain", "pixel",     "points",    "shader",
                                        "shadow",  "test",      "voxelize",  "volume",
                                        "warp",    "fragments", "warp walk", "warp capture" };

/* --- help ------------------------------------------------------------------------------------- */

static void no_command_shows_the_help_on_stderr_and_is_a_usage_error(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe"), 2);
    assert_string_equal(out, "");
    expect_contains(err, "Commands:");
}

static void help_and_version_go_to_stdout(void **state)
{
    (void)state;
    static const char *const lines[] = { "glasspipe -h", "glasspipe --help", "glasspipe help",
                                         "glasspipe help help" };
    for (size_t i = 0; i < GP_COUNT(lines); i++) {
        assert_int_equal(shell("%s", lines[i]), 0);
        assert_string_equal(err, "");
        assert_true(strncmp(out, "Examples:", 9) == 0);
        for (size_t c = 0; c < GP_COUNT(commands); c++)
            expect_contains(out, commands[c]);
    }
    assert_int_equal(shell("glasspipe --version"), 0);
    expect_matches(out, "^glasspipe [0-9]+\\.[0-9]+\\.[0-9]+\n$");
}

static void every_command_shows_examples_before_options(void **state)
{
    (void)state;
    for (size_t c = 0; c < GP_COUNT(commands); c++) {
        assert_int_equal(shell("glasspipe %s -h", commands[c]), 0);
        const char *examples = strstr(out, "Examples:"), *options = strstr(out, "--json");
        assert_true(examples && options && examples < options);
        static char first[sizeof out];
        strcpy(first, out);
        assert_int_equal(shell("glasspipe help %s", commands[c]), 0);
        assert_string_equal(out, first);
        assert_int_equal(shell("glasspipe %s --usage", commands[c]), 0);
        assert_int_equal(shell("glasspipe %s --version", commands[c]), 0);
        expect_contains(out, "glasspipe ");
    }
}

/* Whether an option stands in the text as a word of its own. */
static bool mentions(const char *text, const char *option)
{
    size_t length = strlen(option);
    for (const char *at = strstr(text, option); at; at = strstr(at + 1, option)) {
        char next = at[length];
        bool longer = next == '-' || (next >= 'a' && next <= 'z');
        if (!longer && (at == text || at[-1] != '-'))
            return true;
    }
    return false;
}

/* Calls check for each long option in a text; returns how many. */
static int each_option(const char *text, void (*check)(const char *option, const char *other),
                       const char *other)
{
    int count = 0;
    for (const char *at = strstr(text, "--"); at; at = strstr(at + 2, "--")) {
        size_t length = 2 + strspn(at + 2, "abcdefghijklmnopqrstuvwxyz-");
        char option[64];
        snprintf(option, sizeof option, "%.*s", (int)length, at);
        if (length > 2 && ++count)
            check(option, other);
    }
    return count;
}

static void expect_mentioned(const char *option, const char *text)
{
    if (!mentions(text, option))
        fail_msg("%s is missing in:\n%s", option, text);
}

static void help_and_man_page_have_the_same_options(void **state)
{
    (void)state;
    static char page[1 << 16];
    char name[64];
    for (size_t c = 0; c < GP_COUNT(commands); c++) {
        assert_int_equal(shell("glasspipe %s --help", commands[c]), 0);
        snprintf(name, sizeof name, "glasspipe-%s.1", commands[c]);
        if (strchr(name, ' '))
            *strchr(name, ' ') = '-';
        read_man_page(name, page, sizeof page);
        assert_true(each_option(out, expect_mentioned, page) >= 6);
        assert_true(each_option(page, expect_mentioned, out) >= 6);
    }
}

/* --- wrong arguments -------------------------------------------------------------------------- */

static void unknown_commands_are_usage_errors_with_a_suggestion(void **state)
{
    (void)state;
    expect_refused(2, "rendr scene.json", "did you mean 'render'?");
    expect_refused(2, "pixle", "did you mean 'pixel'?");
    expect_refused(2, "help exlain", "did you mean 'explain'?");
    expect_refused(2, "xyzzyplugh", "unknown command 'xyzzyplugh'");
    assert_null(strstr(err, "did you mean"));
    expect_refused(2, "--json render", "unknown option '--json' before the command");
    expect_refused(2, "''", "unknown command ''");
}

static void wrong_option_values_are_usage_errors_that_name_the_option(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "--size 0x5", "--size" },
        { "--size 5x0", "--size" },
        { "--size axb", "--size" },
        { "--size 64", "--size" },
        { "--size 64x", "--size" },
        { "--size 64x48x3", "--size" },
        { "--size -1x5", "--size" },
        { "--size 32769x5", "--size" },
        { "--size ''", "--size" },
        { "--size 99999999999x1", "--size" },
        { "--size ' 5x5'", "--size" },
        { "--threads -1", "--threads" },
        { "--threads 0", "--threads" },
        { "--threads 100000", "--threads" },
        { "--threads two", "--threads" },
        { "--threads 1.5", "--threads" },
        { "--threads ''", "--threads" },
        { "--threads 99999999999999999999", "--threads" },
        { "--isa foo", "--isa" },
        { "--isa ''", "--isa" },
        { "--executor slow", "--executor" },
        { "--dump", "dump" },
        { "--frobnicate", "frobnicate" },
        { "-x", "x" },
        { "second.json", "second.json" },
    };
    expect_all_refused(2, "render scene.json", wrong, GP_COUNT(wrong));
    expect_refused(2, "render", "expected a scene file");
    expect_refused(2, "explain", "expected a scene file");
    expect_refused(2, "chart", "expected a technique");
    expect_refused(2, "chart nothing", "no technique 'nothing'");
    expect_refused(2, "chart nothing -t -1", "--time");
    expect_refused(2, "compare a.png", "expected two pictures");
    expect_refused(2, "compare a.png b.png --fail -1", "--fail");
    expect_refused(2, "compare a.png b.png --hardfail nan", "--hardfail");
    expect_refused(2, "compare a.png b.png --failpercent 1%", "--failpercent");
    expect_files("scene.json");
}

static void wrong_settings_of_a_technique_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "--map 15", "--map: expected a whole number from 16 to 8192, not '15'" },
        { "--map 8193", "--map" },
        { "--map 1e3", "--map" },
        { "--method soft", "--method: expected" },
        { "--filter ''", "--filter" },
        { "--depth d8", "--depth" },
        { "--bias -1", "--bias" },
        { "--bias nan", "--bias" },
        { "--slope 65", "--slope" },
        { "--normal-offset x", "--normal-offset" },
        { "--fit", "fit" },
        { "--error x", "--error" },
        { "--error -1", "--error" },
        { "--error 5 --map 512", "--error chooses the setting" },
        { "--map 512 --error 5", "--error chooses the setting" },
        { "--curve charts.json", "--curve is for --error" },
        { "--trust-chart", "--trust-chart is for --error" },
        { "--error 5%%", "--error: expected a number" },
        { "--error %", "--error: expected a number" },
        { "--error inf", "--error: expected a number" },
        { "--frobnicate", "frobnicate" },
        { "second.json", "second.json" },
        { "-o picture.gif", "picture.gif" },
    };
    expect_all_refused(2, "shadow scene.json", wrong, GP_COUNT(wrong));
    expect_refused(2, "shadow", "expected a scene file");
    expect_files("scene.json");
}

static void an_unknown_isa_in_the_environment_is_a_usage_error(void **state)
{
    (void)state;
    assert_int_equal(shell("GP_ISA=foo; export GP_ISA; glasspipe render scene.json"), 2);
    assert_string_equal(out, "");
    expect_contains(err, "$GP_ISA: isa 'foo'");
    expect_refused(2, "render scene.json --isa foo", "--isa: expected");
    assert_null(strstr(err, "GP_ISA"));
    expect_files("scene.json");
}

static void bad_outputs_are_refused_before_rendering(void **state)
{
    (void)state;
    expect_refused(2, "render scene.json -o picture.gif", "picture.gif");
    expect_refused(2, "render scene.json -o picture", "picture");
    expect_refused(2, "render scene.json -o ''", "-o");
    assert_int_equal(mkdir("directory.png", 0777), 0);
    expect_refused(2, "render scene.json -o directory.png", "directory");
    assert_int_equal(rmdir("directory.png"), 0);
    expect_refused(4, "render scene.json -o nowhere/picture.png", "nowhere/picture.png");
    expect_files("scene.json");
}

static void empty_arguments_are_usage_errors(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "render ''",    "voxelize ''",   "warp ''", "shader ''", "volume ''",
        "fragments ''", "compare '' ''", "test ''", "bench ''",  "pixel scene.json '' 1"
    };
    for (size_t i = 0; i < GP_COUNT(lines); i++)
        expect_refused(2, lines[i], "an argument is empty");
    expect_files("scene.json");
}

/* --- wrong input ------------------------------------------------------------------------------ */

static void bad_scenes_are_input_errors_that_name_the_file(void **state)
{
    (void)state;
    write_file("text.json", "this is no JSON\n");
    write_file("empty.json", "");
    write_file("cut.json", "{ \"size\": [64, 48], \"camera\": {");
    write_file("mark.json", "\xef\xbb\xbf{ \"objects\": [ { \"mesh\": \"builtin:cube\" } ] }");
    assert_int_equal(shell("glasspipe render -q mark.json --size 8x8 -o a.ppm"), 0);
    write_file("array.json", "[1, 2]");
    write_file("unknown.json", "{ \"size\": [64, 48],\n \"frobnicate\": 1 }");
    static const char *const files[] = { "missing.json", "text.json",    "empty.json", "cut.json",
                                         "array.json",   "unknown.json", "." };
    for (size_t i = 0; i < GP_COUNT(files); i++) {
        char arguments[256];
        snprintf(arguments, sizeof arguments, "render %s", files[i]);
        expect_refused(3, arguments, files[i]);
    }
    expect_refused(3, "explain missing.json", "missing.json");
    expect_refused(3, "pixel missing.json 1 1", "missing.json");
    expect_refused(3, "render unknown.json", "frobnicate");
}

/* What a file says stays in the line, and does nothing to the terminal. */
static void messages_hold_no_control_characters(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "control.json", "mesh: a\\x01\\x0a\\x1b[31mb\\x7f\\xc2\\x9b1m\xc3\xa9: no such file" },
    };
    write_file("control.json", "{ \"objects\": [ { \"mesh\": \"a\\u0001\\n\\u001b[31mb\\u007f"
                               "\\u009b1m\\u00e9\" } ] }");
    expect_input_errors("render", rows, GP_COUNT(rows));
    assert_int_equal(shell("glasspipe render scene.json --size 4x4 -o $(printf 'a\\033b.ppm')"), 0);
    assert_string_equal(err, "wrote a\\x1bb.ppm\n");
}

static void scenes_and_settings_that_do_not_go_together_are_input_errors(void **state)
{
    (void)state;
    static const char cube[] = "\"objects\": [ { \"mesh\": \"builtin:cube\" } ]";
    static const struct {
        const char *lights, *options, *part;
    } cases[] = {
        { "[]", "", "the scene has no light" },
        { "[ { \"position\": [1, 2, 3] } ]", "--method plain", "lights[0] shines to all sides" },
        { "[ { \"position\": [1, 2, 3] } ]", "--map 2731", "at most 2730 texels" },
        { "[ { \"direction\": [1, 2, 3] } ]", "--filter soft", "they need the plain method" },
        { "[ { \"direction\": [1, 2, 3] } ]", "--depth r32f", "r32f is no depth format" },
        { "[ { \"direction\": [1, 2, 3] } ]", "--method plain --depth d16", "in r32f" },
        { "[ { \"direction\": [1, 2, 3] } ]", "--method plain --slope 1", "does not bias" },
        { "[ { \"direction\": [1, 2, 3] } ]", "--error 5 --trust-chart",
          "`glasspipe chart shadow' makes a chart" },
        { "[ { \"direction\": [1, 2, 3] } ]", "--error 5 --curve none.json", "none.json" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        char text[400], arguments[256];
        snprintf(text, sizeof text, "{ \"lights\": %s, %s }", cases[i].lights, cube);
        write_file("lights.json", text);
        snprintf(arguments, sizeof arguments, "shadow lights.json %s", cases[i].options);
        expect_refused(3, arguments, cases[i].part);
    }
    write_file("toon.json", "{ \"objects\": [ { \"mesh\": \"builtin:cube\", "
                            "\"material\": { \"program\": \"toon\" } } ] }");
    expect_refused(3, "shadow toon.json", "objects[0]: program toon");
    write_file("passes.json", "{ \"passes\": [ { \"name\": \"a\" }, { \"name\": \"b\" } ] }");
    expect_refused(3, "shadow passes.json", "passes of its own");
    expect_refused(3, "shadow missing.json", "missing.json");
    expect_files("lights.json passes.json scene.json toon.json");
}

static void unreadable_pictures_are_input_errors(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe render scene.json -o a.png"), 0);
    expect_refused(3, "compare a.png missing.png", "missing.png");
    write_file("text.png", "this is no picture\n");
    expect_refused(3, "compare text.png a.png", "text.png");
    expect_refused(3, "compare a.png .", ".");
    assert_int_equal(shell("head -c 100 a.png >cut.png; glasspipe compare a.png cut.png"), 3);
    expect_contains(err, "cut.png");
}

/* --- render ----------------------------------------------------------------------------------- */

static void render_writes_the_picture_and_prints_its_hash(void **state)
{
    (void)state;
    static const char *const names[] = { "p.png", "p.ppm", "p.exr", "p.pfm" };
    char first[256] = "";
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        assert_int_equal(shell("glasspipe render scene.json -o %s", names[i]), 0);
        expect_matches(out, "^hash [A-Z0-9]+ 64x48 [0-9a-f]{16}\n$");
        expect_contains(err, names[i]);
        if (i == 0)
            strcpy(first, out);
        assert_string_equal(out, first);
    }
    expect_files("p.exr p.pfm p.png p.ppm scene.json");
    char head[32];
    read_file("p.png", head, sizeof head);
    assert_memory_equal(head, "\x89PNG", 4);
    read_file("p.ppm", head, sizeof head);
    assert_memory_equal(head, "P6", 2);
    read_file("p.pfm", head, sizeof head);
    assert_memory_equal(head, "PF", 2);
}

static void render_names_its_picture_after_the_scene(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe render -q ./scene.json"), 0);
    assert_string_equal(err, "");
    expect_files("scene.json scene.png");
    assert_int_equal(mkdir("out", 0777), 0);
    assert_int_equal(shell("glasspipe render scene.json"), 0);
    expect_contains(err, "out/scene.png");
    assert_int_equal(access("out/scene.png", R_OK), 0);
}

static void threads_isa_and_executor_never_change_the_hash(void **state)
{
    (void)state;
    char first[256];
    assert_int_equal(shell("glasspipe render scene.json -o a.png"), 0);
    strcpy(first, out);
    static const char *const same[] = { "--threads 1", "--threads 7", "--isa auto",
                                        "--executor reference" };
    for (size_t i = 0; i < GP_COUNT(same); i++) {
        assert_int_equal(shell("glasspipe render scene.json -o b.png %s", same[i]), 0);
        assert_string_equal(out, first);
    }
    assert_int_equal(shell("glasspipe render scene.json -o b.png --size 65x48"), 0);
    expect_contains(out, " 65x48 ");
}

static void shadow_draws_the_same_bits_on_everything_and_tells_its_setting(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe shadow -q scene.json --map 64 -o a.png"), 0);
    expect_matches(out, "^hash A8R8G8B8 64x48 [0-9a-f]{16}\n$");
    static char first[sizeof out];
    strcpy(first, out);
    assert_int_equal(shell("glasspipe shadow -q scene.json --map=64 -o a.png --threads 3"), 0);
    assert_string_equal(out, first);
    assert_int_equal(shell("glasspipe shadow -q scene.json --map 64 --executor reference"), 0);
    assert_string_equal(out, first);
    assert_int_equal(shell("glasspipe shadow -q scene.json --map 65 -o a.png --json"), 0);
    json_t *object = parse_output();
    expect_contains(json_string_value(json_object_get(object, "setting")), " --map 65 ");
    json_decref(object);
    expect_files("a.png scene.json scene.png");
}

static void render_json_has_the_hash_times_and_counters(void **state)
{
    (void)state;
    char hash[256];
    assert_int_equal(shell("glasspipe render scene.json -o a.png"), 0);
    strcpy(hash, out);
    assert_int_equal(shell("glasspipe render scene.json -o a.png --json --executor reference"), 0);
    json_t *object = parse_output();
    static const char *const numbers[] = { "ms", "first_ms", "cpu_ms" };
    for (size_t i = 0; i < GP_COUNT(numbers); i++)
        assert_true(json_number_value(json_object_get(object, numbers[i])) > 0);
    static const char *const integers[] = { "threads",    "passes",    "draws",
                                            "primitives", "fragments", "pixels_written" };
    for (size_t i = 0; i < GP_COUNT(integers); i++)
        assert_true(json_integer_value(json_object_get(object, integers[i])) > 0);
    assert_int_equal(json_integer_value(json_object_get(object, "width")), 64);
    assert_int_equal(json_integer_value(json_object_get(object, "height")), 48);
    assert_non_null(json_string_value(json_object_get(object, "isa")));
    expect_contains(hash, json_string_value(json_object_get(object, "hash")));
    json_decref(object);
}

/* Adds the names of a man page's JSON section, ".B ms, cpu_ms" each, to a set; of those that follow
 * what the reference executor alone counts only where that drew. */
static json_t *members_of_page(const char *page, bool reference)
{
    json_t *names = json_object();
    const char *end = strstr(page, ".SH EXIT STATUS");
    for (const char *at = strstr(page, ".SH JSON"); (at = strstr(at, "\n.B ")) && at < end;) {
        char line[200], *rest = line;
        at += 4;
        snprintf(line, sizeof line, "%.*s", (int)strcspn(at, "\n"), at);
        const bool alone = strncmp(strchr(at, '\n'), "\nThe same; counted by --executor", 32) == 0;
        for (char *name = strsep(&rest, " ,"); name; name = strsep(&rest, " ,"))
            if (name[0] && (reference || !alone))
                json_object_set_new(names, name, json_true());
    }
    return names;
}

static void render_json_has_the_members_of_its_man_page_and_no_other(void **state)
{
    (void)state;
    static char page[1 << 16];
    static const char *const executors[] = { "fast", "reference" };
    read_man_page("glasspipe-render.1", page, sizeof page);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(shell("glasspipe render scene.json --json --executor=%s", executors[i]),
                         0);
        json_t *object = parse_output(), *names = members_of_page(page, i == 1), *value;
        const char *name;
        json_object_foreach(object, name, value) if (json_object_del(names, name)) fail_msg(
            "%s is printed by the executor %s, but not in the man page", name, executors[i]);
        json_object_foreach(names, name, value) fail_msg(
            "%s is in the man page, but not printed by the executor %s", name, executors[i]);
        json_decref(object);
        json_decref(names);
    }
}

static void passes_can_be_listed_and_dumped(void **state)
{
    (void)state;
    char picture[256];
    assert_int_equal(shell("glasspipe render scene.json -o a.png"), 0);
    strcpy(picture, out);
    assert_int_equal(shell("glasspipe render scene.json --list-passes"), 0);
    expect_contains(out, "64x48");
    assert_int_equal(shell("glasspipe render scene.json --list-passes --json"), 0);
    json_t *object = parse_output(), *passes = json_object_get(object, "passes");
    size_t last = json_array_size(passes) - 1;
    const char *name = json_string_value(json_object_get(json_array_get(passes, last), "name"));
    assert_int_equal(shell("glasspipe render scene.json -o b.png --dump %zu", last), 0);
    assert_string_equal(out, picture);
    assert_int_equal(shell("glasspipe render scene.json -o b.png --dump '%s'", name), 0);
    assert_string_equal(out, picture);
    assert_int_equal(shell("glasspipe render scene.json -o d.png --dump '%s.depth'", name), 0);
    expect_matches(out, "^hash D[0-9SF]+ 64x48 ");
    assert_int_equal(shell("glasspipe render scene.json -o d.pfm --dump '%s.depth'", name), 0);
    json_decref(object);
    expect_refused(2, "render scene.json --dump nothing", "--dump nothing");
    expect_refused(2, "render scene.json --dump 0.3", "--dump 0.3");
    expect_refused(2, "render scene.json --dump 99", "--dump 99");
}

static void a_failed_write_keeps_the_old_file_and_leaves_no_other(void **state)
{
    (void)state;
    write_file("a.exr", "old");
    assert_int_equal(shell("(ulimit -f 1; glasspipe render scene.json --size 512x512 -o a.exr)"),
                     4);
    assert_string_equal(out, "");
    expect_contains(err, "a.exr");
    char text[16];
    read_file("a.exr", text, sizeof text);
    assert_string_equal(text, "old");
    expect_files("a.exr scene.json");
}

/* Kilobytes at the most that any program had that has ended, and was waited for. */
static long most_memory(void)
{
    struct rusage usage;
    assert_int_equal(getrusage(RUSAGE_CHILDREN, &usage), 0);
    return usage.ru_maxrss;
}

/* Two targets of 64 MB and the bytes of the file; as floats the picture alone was 256. */
static void a_large_picture_takes_little_more_than_its_targets(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe render scene.json --size 4096x4096 -o a.ppm"), 0);
    if (limits_hold() && most_memory() > 300 << 10)
        fail_msg("%ld KB", most_memory());
}

/* --- stdout ----------------------------------------------------------------------------------- */

static void a_full_or_closed_stdout_is_an_internal_error_with_a_message(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe render scene.json -o a.png >/dev/full"), 4);
    expect_contains(err, "standard output: No space left on device");
    assert_int_equal(shell("glasspipe --help >/dev/full"), 4);
    assert_int_equal(shell("glasspipe render --help >/dev/full"), 4);
    expect_contains(err, "standard output");
    assert_int_equal(shell("glasspipe render scene.json -o a.png >&-"), 4);
    expect_contains(err, "standard output");
    char magic[8]; /* the picture did not become descriptor 1 */
    read_file("a.png", magic, sizeof magic);
    assert_memory_equal(magic, "\x89PNG", 4);
}

static void a_reader_that_left_is_an_error_and_no_signal(void **state)
{
    (void)state;
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    close(ends[0]);
    pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        dup2(open("message", O_WRONLY | O_CREAT, 0666), STDERR_FILENO);
        execl(binary, "glasspipe", "--help", (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 4);
    read_file("message", err, sizeof err);
    expect_contains(err, "Broken pipe");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(no_command_shows_the_help_on_stderr_and_is_a_usage_error),
        PROGRAM_TEST(help_and_version_go_to_stdout),
        PROGRAM_TEST(every_command_shows_examples_before_options),
        PROGRAM_TEST(help_and_man_page_have_the_same_options),
        PROGRAM_TEST(unknown_commands_are_usage_errors_with_a_suggestion),
        PROGRAM_TEST(wrong_option_values_are_usage_errors_that_name_the_option),
        PROGRAM_TEST(wrong_settings_of_a_technique_are_usage_errors),
        PROGRAM_TEST(an_unknown_isa_in_the_environment_is_a_usage_error),
        PROGRAM_TEST(bad_outputs_are_refused_before_rendering),
        PROGRAM_TEST(empty_arguments_are_usage_errors),
        PROGRAM_TEST(messages_hold_no_control_characters),
        PROGRAM_TEST(bad_scenes_are_input_errors_that_name_the_file),
        PROGRAM_TEST(scenes_and_settings_that_do_not_go_together_are_input_errors),
        PROGRAM_TEST(unreadable_pictures_are_input_errors),
        PROGRAM_TEST(render_writes_the_picture_and_prints_its_hash),
        PROGRAM_TEST(render_names_its_picture_after_the_scene),
        PROGRAM_TEST(threads_isa_and_executor_never_change_the_hash),
        PROGRAM_TEST(shadow_draws_the_same_bits_on_everything_and_tells_its_setting),
        PROGRAM_TEST(render_json_has_the_hash_times_and_counters),
        PROGRAM_TEST(render_json_has_the_members_of_its_man_page_and_no_other),
        PROGRAM_TEST(passes_can_be_listed_and_dumped),
        PROGRAM_TEST(a_failed_write_keeps_the_old_file_and_leaves_no_other),
        PROGRAM_TEST(a_large_picture_takes_little_more_than_its_targets),
        PROGRAM_TEST(a_full_or_closed_stdout_is_an_internal_error_with_a_message),
        PROGRAM_TEST(a_reader_that_left_is_an_error_and_no_signal),
    };
    return cmocka_run_group_tests_name("program", tests, find_program, NULL);
}
