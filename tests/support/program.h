/* The built binary, run in an empty directory of each test's own, and judged by its exit code, its
 * two outputs and the files that it leaves.
 *
 * GLASSPIPE_BIN names the binary (default out/bin/glasspipe), GLASSPIPE_MAN the directory of the
 * man pages (default apps/man), EMULATOR the command that runs it. */
#ifndef TESTS_PROGRAM_H
#define TESTS_PROGRAM_H

#include "tests/support/unit.h"

#include <dirent.h>
#include <jansson.h>
#include <limits.h>
#include <regex.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

static char binary[PATH_MAX], man_pages[PATH_MAX];
static char out[1 << 20], err[1 << 16]; /* what the last run printed */

static const char scene[] =
    "{ \"size\": [64, 48], \"background\": [0.25, 0.5, 0.75, 1],\n"
    "  \"camera\": { \"eye\": [2, 1.5, 3], \"at\": [0, 0, 0], \"up\": [0, 1, 0], \"fovy\": 40,\n"
    "              \"near\": 0.1, \"far\": 20 },\n"
    "  \"objects\": [ { \"mesh\": \"builtin:cube\", \"fit\": [0, -0.5, 0, 1],\n"
    "                 \"material\": { \"program\": \"phong\" } } ] }\n";

static inline void write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

static inline size_t read_file(const char *path, char *text, size_t size)
{
    FILE *file = fopen(path, "r");
    if (!file)
        fail_msg("%s: cannot be read", path);
    size_t length = fread(text, 1, size - 1, file);
    fclose(file);
    text[length] = '\0';
    return length;
}

/* A man page's text without the backslashes of its dashes. */
static inline void read_man_page(const char *name, char *text, size_t size)
{
    char path[PATH_MAX + 64];
    snprintf(path, sizeof path, "%s/%s", man_pages, name);
    read_file(path, text, size);
    char *to = text;
    for (const char *from = text; *from; from++)
        if (*from != '\\' || from[1] != '-')
            *to++ = *from;
    *to = '\0';
}

/* Runs a shell line in which `glasspipe` is the binary; fills out and err; returns the exit code.
 */
static inline int shell(const char *format, ...) __attribute__((format(printf, 1, 2)));

static inline int shell(const char *format, ...)
{
    char line[4096];
    va_list args;
    va_start(args, format);
    int used =
        snprintf(line, sizeof line, "glasspipe() { ${EMULATOR:-} '%s' \"$@\"; }\n{ ", binary);
    used += vsnprintf(line + used, sizeof line - (size_t)used, format, args);
    snprintf(line + used, sizeof line - (size_t)used, "\n} >.out 2>.err");
    va_end(args);
    int status = system(line);
    read_file(".out", out, sizeof out);
    read_file(".err", err, sizeof err);
    unlink(".out");
    unlink(".err");
    if (!WIFEXITED(status))
        fail_msg("killed: %s", line);
    return WEXITSTATUS(status);
}

static inline void expect_contains(const char *text, const char *part)
{
    if (!strstr(text, part))
        fail_msg("'%s' is not in:\n%s", part, text);
}

/* A refusal: this code, nothing on stdout, and this in the message. */
static inline void expect_refused(int code, const char *arguments, const char *part)
{
    int got = shell("glasspipe %s", arguments);
    if (got != code)
        fail_msg("glasspipe %s: exit code %d instead of %d\n%s", arguments, got, code, err);
    assert_string_equal(out, "");
    expect_contains(err, "glasspipe");
    expect_contains(err, part);
}

/* A table of refusals: what follows the command, and what is in the message. */
static inline void expect_all_refused(int code, const char *command, const char *const (*rows)[2],
                                      size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char arguments[256];
        snprintf(arguments, sizeof arguments, "%s %s", command, rows[i][0]);
        expect_refused(code, arguments, rows[i][1]);
    }
}

/* A table of wrong inputs: each is told of in one line. */
static inline void expect_input_errors(const char *command, const char *const (*rows)[2],
                                       size_t count)
{
    for (size_t i = 0; i < count; i++) {
        expect_all_refused(3, command, &rows[i], 1);
        const char *end = strchr(err, '\n');
        if (!end || end[1])
            fail_msg("more than a line: %s", err);
    }
}

static inline void expect_files(const char *expected)
{
    char names[4096] = "";
    struct dirent **entries;
    int count = scandir(".", &entries, NULL, alphasort);
    for (int i = 0; i < count; i++) {
        if (strcmp(entries[i]->d_name, ".") != 0 && strcmp(entries[i]->d_name, "..") != 0) {
            strcat(names, names[0] ? " " : "");
            strcat(names, entries[i]->d_name);
        }
        free(entries[i]);
    }
    free(entries);
    assert_string_equal(names, expected);
}

static inline void expect_matches(const char *text, const char *pattern)
{
    regex_t regex;
    assert_int_equal(regcomp(&regex, pattern, REG_EXTENDED | REG_NOSUB), 0);
    int result = regexec(&regex, text, 0, NULL, 0);
    regfree(&regex);
    if (result)
        fail_msg("no match of %s in:\n%s", pattern, text);
}

static inline json_t *parse_output(void)
{
    json_error_t error;
    json_t *object = json_loads(out, 0, &error);
    if (!object)
        fail_msg("no JSON: %s in:\n%s", error.text, out);
    return object;
}

/* A table of options, and what they say when all is said: a command has the same setting with
 * both. */
static inline void expect_same_settings(const char *command, const char *const (*rows)[2],
                                        size_t count)
{
    for (size_t i = 0; i < count; i++) {
        json_t *object[2];
        for (int k = 0; k < 2; k++) {
            assert_int_equal(shell("glasspipe %s -q --json -o a.png %s", command, rows[i][k]), 0);
            object[k] = parse_output();
        }
        assert_string_equal(json_string_value(json_object_get(object[0], "setting")),
                            json_string_value(json_object_get(object[1], "setting")));
        json_decref(object[0]);
        json_decref(object[1]);
    }
}

/* That a.png is the picture that the README shows. */
static inline void expect_stored_picture(const char *name)
{
    if (shell("glasspipe compare a.png '%s/../../scenes/pictures/%s.png'", man_pages, name))
        fail_msg("%s: %s%s", name, out, err);
}

/* Every test starts in an empty directory of its own that holds the scene. */
static inline int enter(void **state)
{
    static char directory[64];
    snprintf(directory, sizeof directory, "/tmp/glasspipe-cli-XXXXXX");
    *state = mkdtemp(directory);
    if (!*state || chdir(directory))
        return -1;
    write_file("scene.json", scene);
    return 0;
}

static inline int leave(void **state)
{
    char line[128];
    snprintf(line, sizeof line, "rm -rf '%s'", (const char *)*state);
    return chdir("/") || system(line);
}

/* The setup of each group: fails, after a message, where there is no program. */
static inline int find_program(void **state)
{
    const char *path = getenv("GLASSPIPE_BIN"), *man = getenv("GLASSPIPE_MAN");
    (void)state;
    unsetenv("GP_ISA");
    if (realpath(path ? path : "out/bin/glasspipe", binary) &&
        realpath(man ? man : "apps/man", man_pages))
        return 0;
    fputs("no glasspipe binary or man pages; see GLASSPIPE_BIN, GLASSPIPE_MAN\n", stderr);
    return -1;
}

#define PROGRAM_TEST(function) cmocka_unit_test_setup_teardown(function, enter, leave)

#endif
