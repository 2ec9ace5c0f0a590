#include "apps/dispatch.h"

#include "apps/commands/commands.h"
#include "apps/commands/options.h"
#include "apps/commands/technique_command.h"
#include "apps/techniques/registry.h"

#include <string.h>

typedef struct Command {
    const char *name;
    CommandFn *run;
    const char *arguments, *summary;
} Command;

static const Command commands[] = {
    { "render", cmd_render, "SCENE.json", "render a scene, pass by pass, to a picture" },
    { "compare", cmd_compare, "A B", "compare two pictures" },
    { "test", cmd_test, "DIR [NAME]", "hold scenes against pictures stored beside them" },
    { "explain", cmd_explain, "SCENE.json", "what each draw needs, and its shaders' limits" },
    { "pixel", cmd_pixel, "SCENE.json X Y", "the history of one pixel" },
    { "inspect", cmd_inspect, "SCENE.json", "a frame, stage by stage, as a page" },
    { "bench", cmd_bench, "[CASE...]", "draw workloads against the clock" },
    { "shader", cmd_shader, "FILE.c", "draw a model with a shader of your own" },
    { "chart", cmd_chart, "TECHNIQUE", "speed against accuracy of a technique's settings" },
    { "warp walk", cmd_warp_walk, "[MESH...]", "a way among depth images, frame by frame" },
    { "warp capture", cmd_warp_capture, "MESH", "a depth image, to be warped, as a file" },
};

static void print_line(FILE *file, const char *name, const char *arguments, const char *summary)
{
    const int room = strchr(name, ' ') ? 0 : 9; /* two words are longer than the first column */
    char call[64];
    snprintf(call, sizeof call, "%-*s %s", room, name, arguments);
    fprintf(file, "  %-25s %s\n", call, summary);
}

void commands_help(FILE *file)
{
    fputs("Examples:\n"
          "  glasspipe render scenes/shadow.json --size 512x384 -o plain.png\n"
          "  glasspipe shadow scenes/shadow.json --size 512x384 -o shadow.png\n"
          "  glasspipe compare plain.png shadow.png\n"
          "  glasspipe pixel scenes/shadow.json 500 400\n"
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
    print_line(file, "help", "[COMMAND]", "this help, or a command's");
    fputs("\n"
          "  -h, --help                 this help; after a command, its options\n"
          "      --version              the version\n"
          "\n"
          "Exit codes: 0 done; 1 compared and differ, or a check failed; 2 usage;\n"
          "3 bad input; 4 internal error, or the output could not be written.\n",
          file);
}

/* The i'th name of a command; NULL behind the last. */
static const char *command_name(size_t i)
{
    if (i < GP_COUNT(commands))
        return commands[i].name;
    const Technique *const technique = technique_registry[i - GP_COUNT(commands)];
    return technique ? technique->name : NULL;
}

/* Number of single-letter edits (insert, delete, replace) from a to b: Levenshtein's distance, one
 * row of the table at a time. Words of over 31 letters are no typing errors: they are simply
 * far. */
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

/* Whether a command's name is a word and the one behind it: "warp capture". */
static bool is_asked(const char *command, const char *name, int argc, char **argv, bool *has_two)
{
    const size_t length = strlen(name);
    *has_two = strncmp(command, name, length) == 0 && command[length] == ' ';
    return *has_two ? argc > 1 && strcmp(command + length + 1, argv[1]) == 0
                    : strcmp(command, name) == 0;
}

int commands_run(const char *name, int argc, char **argv)
{
    char title[32];
    bool has_two;
    const Technique *technique = technique_find(technique_registry, name);
    for (size_t i = 0; i < GP_COUNT(commands); i++)
        if (is_asked(commands[i].name, name, argc, argv, &has_two)) {
            snprintf(title, sizeof title, "glasspipe %s", commands[i].name);
            argv[has_two] = title;
            return commands[i].run(argc - has_two, argv + has_two);
        }
    snprintf(title, sizeof title, "glasspipe %s", name);
    argv[0] = title;
    return technique ? technique_command(technique, argc, argv) : unknown_command(name);
}
