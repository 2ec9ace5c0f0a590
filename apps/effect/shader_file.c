#include "apps/effect/shader_file.h"

#include "apps/base/text.h"
#include "pipeline/io/file.h"
#include "pipeline/list/isa.h"

#include <ctype.h>
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* --- which programs there are ----------------------------------------------------------------- */

enum { MAX_PROGRAMS = 32 };

typedef char ProgramName[128];

/* Names in `program(NAME,` and `depth_program(NAME,` at the beginning of a line. */
static int find_programs(const char *text, ProgramName names[MAX_PROGRAMS])
{
    int count = 0;
    for (const char *line = text; line && count < MAX_PROGRAMS; line = strchr(line, '\n')) {
        line += *line == '\n';
        const char *at = strncmp(line, "depth_", 6) == 0 ? line + 6 : line;
        if (strncmp(at, "program(", 8) != 0)
            continue;
        for (at += 8; isspace((unsigned char)*at); at++)
            continue;
        int length = 0;
        while (isalnum((unsigned char)at[length]) || at[length] == '_')
            length++;
        snprintf(names[count++], sizeof names[0], "%.*s", length, at);
    }
    return count;
}

/* Number of the program of a name, or of the only one.
 * in list: their names, for messages */
static GpResult choose(const char *path, const char *wanted, ProgramName *names, int count,
                       const char *list, int *chosen, GpError *error)
{
    *chosen = wanted || count > 1 ? -1 : 0;
    for (int i = 0; wanted && i < count; i++)
        if (strcmp(names[i], wanted) == 0)
            *chosen = i;
    if (count == 0)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: no line begins with program(NAME, ...) or depth_program(NAME, ...)",
                       path);
    if (*chosen < 0 && wanted)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: no program %s; there is %s", path, wanted,
                       list);
    if (*chosen < 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: choose one by --program: %s", path, list);
    return GP_OK;
}

static GpResult choose_program(const char *path, const char *wanted, ProgramName name,
                               GpError *error)
{
    ProgramName names[MAX_PROGRAMS];
    Text list = { .data = NULL };
    GpFile file;
    GpResult result = gp_file_read(path, &file, error);
    if (result)
        return result;
    const int count = find_programs(file.data, names);
    gp_file_free(&file);
    int chosen;
    for (int i = 0; i < count; i++)
        text_add(&list, "%s%s", i ? ", " : "", names[i]);
    result = choose(path, wanted, names, count, list.data ? list.data : "", &chosen, error);
    text_free(&list);
    if (!result)
        memcpy(name, names[chosen], sizeof names[0]);
    return result;
}

/* --- building --------------------------------------------------------------------------------- */

/* The folder that holds bin/, include/ and share/: the program's own place tells it. */
static GpResult find_prefix(char prefix[PATH_MAX], GpError *error)
{
    const ssize_t length = readlink("/proc/self/exe", prefix, PATH_MAX - 1);
    prefix[length > 0 ? length : 0] = '\0';
    for (int up = 0; up < 2; up++) {
        char *slash = strrchr(prefix, '/');
        if (!slash)
            return gp_fail(error, GP_ERROR_UNSUPPORTED, "this program's own place is not known");
        *slash = '\0';
    }
    return GP_OK;
}

/* The widths that this processor runs, "4 8". */
static void list_widths(char widths[16])
{
    widths[0] = '\0';
    for (int lanes = 4; lanes <= 16; lanes *= 2)
        if (gp_isa_of_lanes(lanes))
            snprintf(widths + strlen(widths), 16 - strlen(widths), "%s%d", lanes > 4 ? " " : "",
                     lanes);
}

/* Starts the script, which prints into a pipe's end. returns 0 or an errno */
static int start_script(const char *const arguments[], const int ends[2], pid_t *child)
{
    posix_spawn_file_actions_t actions;
    int problem = posix_spawn_file_actions_init(&actions);
    if (problem)
        return problem;
    problem = posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    for (int i = 0; i < 2 && !problem; i++)
        problem = posix_spawn_file_actions_addclose(&actions, ends[i]);
    if (!problem)
        problem = posix_spawnp(child, "sh", &actions, NULL, (char *const *)(const void *)arguments,
                               environ);
    posix_spawn_file_actions_destroy(&actions);
    return problem;
}

/* Runs the script.
 * out line: the first that it printed, without its end
 * returns its exit status; -1: it did not run */
static int run_script(const char *const arguments[], char *line, size_t size)
{
    int ends[2], status = -1;
    pid_t child;
    if (pipe(ends))
        return -1;
    const int problem = start_script(arguments, ends, &child);
    close(ends[1]);
    size_t length = 0;
    ssize_t got = 0;
    while (!problem && length + 1 < size &&
           ((got = read(ends[0], line + length, size - 1 - length)) > 0 ||
            (got < 0 && errno == EINTR)))
        length += got > 0 ? (size_t)got : 0;
    line[length] = '\0';
    line[strcspn(line, "\n")] = '\0';
    close(ends[0]);
    if (problem || waitpid(child, &status, 0) != child || got < 0 || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

static GpResult build(const char *path, char library[PATH_MAX], GpError *error)
{
    char prefix[PATH_MAX], script[PATH_MAX + 64], widths[16];
    GpResult result = find_prefix(prefix, error);
    if (result)
        return result;
    snprintf(script, sizeof script, "%s/share/glasspipe/build_shader.sh", prefix);
    list_widths(widths);
    if (access(script, R_OK))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s is missing: make install brings it",
                       script);
    const char *const arguments[] = { "sh", script, prefix, path, widths, NULL };
    const int status = run_script(arguments, library, PATH_MAX);
    if (status == 0 && library[0])
        return GP_OK;
    if (status == 3)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: not compiled, for the reason above", path);
    if (status < 0)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory or no process to run a compiler in",
                       path);
    return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: not built", path);
}

GpResult shader_file_open(const char *path, const char *name, ShaderFile *file, GpError *error)
{
    char library[PATH_MAX];
    ProgramName chosen;
    GpResult result = choose_program(path, name, chosen, error);
    if (!result)
        result = build(path, library, error);
    if (result)
        return result;
    errno = 0;
    ShaderFile made = { .library = dlopen(library, RTLD_NOW | RTLD_LOCAL) };
    if (!made.library && errno == ENOMEM)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: out of memory", path);
    if (!made.library)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: %s", path, dlerror());
    made.program = dlsym(made.library, chosen);
    if (!made.program) {
        shader_file_close(&made);
        return gp_fail(error, GP_ERROR_FORMAT, "%s: program %s is not in what was compiled", path,
                       chosen);
    }
    *file = made;
    return GP_OK;
}

void shader_file_close(ShaderFile *file)
{
    if (file->library)
        dlclose(file->library);
    *file = (ShaderFile){ 0 };
}
