/* A subcommand's syntax as data, from which argp's parser is made in one place. */
#ifndef APPS_COMMANDS_COMMAND_H
#define APPS_COMMANDS_COMMAND_H

#include "apps/commands/options.h"
#include "apps/techniques/settings.h"

#include <argp.h>

typedef struct CommandSyntax {
    OptionsShared shared;
    const SettingField *options; /* of the command's struct; NULL: none */
    const char *arguments;       /* for the help: "SCENE.json X Y" */
    const char *help;            /* examples first; behind \v what follows the options */

    /* Positional arguments: members const char *[most], NULL where they were not given. */
    size_t offset;
    int least, most;
    const char *expected; /* "a scene file, X and Y" */

    /* Instead of these: takes one, any number of times; a usage error where it is wrong. */
    void (*take)(struct argp_state *state, void *args, const char *text);
    /* Whether all goes together; a usage error where it does not. NULL: it does. */
    void (*check)(struct argp_state *state, void *args);
} CommandSyntax;

/* A table of options and the struct whose members they set. */
typedef struct CommandOptions {
    const SettingField *fields;
    void *object;
    uint32_t given; /* out: bit i: fields[i] was given */
} CommandOptions;

/* Parses a command's arguments into its struct, which begins with an Options and has its defaults.
 * Does not return after a usage error (exit 2), --help, --usage or --version (exit 0).
 * in/out more: options of another struct; NULL: none */
void command_parse(const CommandSyntax *syntax, CommandOptions *more, int argc, char **argv,
                   void *args);

/* A usage error where a word is no decimal number of low..high; `what` names it. */
long command_number(struct argp_state *state, const char *what, const char *text, long low,
                    long high);

#endif
