/* A subcommand's syntax as data, from which argp's parser is made in one place. */
#ifndef APPS_COMMANDS_COMMAND_H
#define APPS_COMMANDS_COMMAND_H

#include "apps/commands/options.h"

typedef enum OptionType {
    OPTION_FLAG = 1, /* bool: there, or not; without a value */
    OPTION_TEXT,     /* const char *, borrowed */
    OPTION_REAL,     /* double >= 0 */
} OptionType;

typedef struct CommandOption {
    const char *name; /* "output": the option --output; NULL ends a table */
    char letter;      /* 'o': the option -o too; 0: none */
    const char *argument, *help;
    OptionType type;
    size_t offset; /* of the member that it sets */
} CommandOption;

typedef struct CommandSyntax {
    const struct argp *shared;    /* options_common, options_run or options_frame */
    const CommandOption *options; /* NULL: none */
    const char *arguments;        /* for the help: "SCENE.json X Y" */
    const char *help;             /* examples first; behind \v what follows the options */

    /* Positional arguments: members const char *[most], NULL where they were not given. */
    size_t offset;
    int least, most;
    const char *expected; /* "a scene file, X and Y" */

    /* Instead of these: takes one, any number of times; a usage error where it is wrong. */
    void (*take)(struct argp_state *state, void *args, const char *text);
    /* Whether all goes together; a usage error where it does not. NULL: it does. */
    void (*check)(struct argp_state *state, void *args);
} CommandSyntax;

enum { COMMAND_MAX_OPTIONS = 12 };

/* Parses a command's arguments into its struct, which begins with an Options and has its defaults.
 * Does not return after a usage error (exit 2), --help, --usage or --version (exit 0). */
void command_parse(const CommandSyntax *syntax, int argc, char **argv, void *args);

#endif
