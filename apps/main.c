/* The program `glasspipe`: finds the subcommand and makes sure that its output arrived. */
#include "apps/commands/commands.h"
#include "apps/commands/options.h"
#include "apps/commands/technique_command.h"
#include "apps/techniques/registry.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct Command {
    const char *name;
    CommandFn *run;
    const char *arguments, *summary;
} Command;

static const Command commands[] = {
    { "render", cmd_render, "SCENE.json", "render a scene, pass by pass, to a picture" },
    { "compare", cmd_compare, "A B", "compare two pictures" },
    { "explain", cmd_explain, "SCENE.json", "what each draw needs, and its shaders' limits" },
    { "pixel", cmd_pixel, "SCENE.json X Y", "the history of one pixel" },
    { "bench", cmd_bench, "[CASE...]", "draw workloads against the clock" },
    { "chart", cmd_chart, "TECHNIQUE", "speed against accuracy of a technique's settings" },
};

static void print_line(FILE *file, const char *name, const char *arguments, const char *summary)
{
    fprintf(file, "  %-8s %-15s %s\n", name, arguments, summary);
}

static void print_help(FILE *file)
{
    fputs("Examples:\n"
          "  glasspipe render scenes/bunny.json -o bunny.png\n"
          "  glasspipe compare bunny.png yesterday.png\n"
          "  glasspipe pixel scenes/bunny.json 256 200\n"
          "\n"
          "Usage: glasspipe COMMAND [OPTION...]\n"
          "\n"
          "A software GPU of the 2005 class that gives the same bits everywhere.\n"
          "\n"
          "Commands:\n",
          file);
    for (size_t i = 0; i < GP_COUNT(commands); i++)
        print_line(file, commands[i].name, commands[i].arguments, commands[i].summary);
    for (const Technique *const *one = technique_registry; *one; one++)
        print_line(file, (*one)->name, (*one)->arguments, (*one)->summary);
    fputs("  help     [COMMAND]       this help, or a command's\n"
          "\n"
          "  -h, --help                 this help; after a command, its options\n"
          "      --version              the version\n"
          "\n"
          "Exit codes: 0 done; 1 compared and differ, or a check failed; 2 usage;\n"
          "3 bad input; 4 internal error, or the output could not be written.\n",
          file);
}

/* Number of single-letter edits (insert, delete, replace) from a to b: Levenshtein's distance, one
 * row of the table at a time. Long words are no typing errors: they are simply far. */
static size_t edit_distance(const char *a, const char *b)
{
    enum { LONGEST = 31 };
    size_t row[LONGEST + 1], length = strlen(b);
    if (strlen(a) > LONGEST || length > LONGEST)
        return LONGEST;
    for (size_t j = 0; j <= length; j++)
        row[j] = j;
    for (size_t i = 1; a[i - 1]; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= length; j++) {
            size_t replace = diagonal + (a[i - 1] != b[j - 1]);
            size_t insert = row[j - 1] + 1, remove = row[j] + 1;
            diagonal = row[j];
            row[j] = insert < remove ? insert : remove;
            row[j] = row[j] < replace ? row[j] : replace;
        }
    }
    return row[length];
}

/* The i'th name of a command; NULL behind the last. */
static const char *command_name(size_t i)
{
    if (i < GP_COUNT(commands))
        return commands[i].name;
    const Technique *const technique = technique_registry[i - GP_COUNT(commands)];
    return technique ? technique->name : NULL;
}

static int unknown_command(const char *name)
{
    const char *closest = command_name(0);
    for (size_t i = 1; command_name(i); i++)
        if (edit_distance(name, command_name(i)) < edit_distance(name, closest))
            closest = command_name(i);
    if (name[0] == '-')
        report(EXIT_USAGE, "unknown option '%s' before the command", name);
    else if (edit_distance(name, closest) <= 3)
        report(EXIT_USAGE, "unknown command '%s'; did you mean '%s'?", name, closest);
    else
        report(EXIT_USAGE, "unknown command '%s'", name);
    fputs("Try 'glasspipe --help'.\n", stderr);
    return EXIT_USAGE;
}

static int run_command(const char *name, int argc, char **argv)
{
    char title[32];
    const Technique *technique = technique_find(technique_registry, name);
    snprintf(title, sizeof title, "glasspipe %s", name);
    argv[0] = title;
    for (size_t i = 0; i < GP_COUNT(commands); i++)
        if (strcmp(commands[i].name, name) == 0)
            return commands[i].run(argc, argv);
    return technique ? technique_command(technique, argc, argv) : unknown_command(name);
}

static int dispatch(int argc, char **argv)
{
    const char *name = argv[1];
    bool help = strcmp(name, "help") == 0;
    if (help && argc > 2) {
        char option[] = "--help";
        char *arguments[] = { NULL, option, NULL };
        return run_command(argv[2], 2, arguments);
    }
    if (help || strcmp(name, "-h") == 0 || strcmp(name, "--help") == 0) {
        print_help(stdout);
        return EXIT_DONE;
    }
    if (strcmp(name, "--version") == 0) {
        puts("glasspipe " GP_VERSION);
        return EXIT_DONE;
    }
    return run_command(name, argc - 1, argv + 1);
}

/* A result that did not reach its reader is a failure. Runs at exit, whoever calls it. */
static void close_stdout(void)
{
    bool failed = ferror(stdout) != 0;
    errno = 0;
    if (fclose(stdout) != 0 || failed) {
        const char *reason = errno ? strerror(errno) : "write error";
        _exit(report(EXIT_INTERNAL, "standard output: %s", reason));
    }
}

/* Where a caller closed descriptor 0, 1 or 2, the next file opened would take its number and
 * receive our messages. They are filled here with ones that refuse the operation. */
static void reserve_standard_files(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0)
            (void)!open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char **argv)
{
    reserve_standard_files();
    signal(SIGPIPE, SIG_IGN); /* write errors like any other, for close_stdout and the writers */
    signal(SIGXFSZ, SIG_IGN);
    atexit(close_stdout);
    if (argc < 2) {
        print_help(stderr);
        return EXIT_USAGE;
    }
    return dispatch(argc, argv);
}
