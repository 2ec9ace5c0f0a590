/* Which subcommand a command line asks for. */
#ifndef APPS_DISPATCH_H
#define APPS_DISPATCH_H

#include <stdio.h>

/* The program's help. */
void commands_help(FILE *file);

/* Runs the subcommand of a name, of a technique or one of apps/commands/commands.h, whose second
 * word may be argv[1]; the words of its name are replaced.
 * returns the program's exit code; EXIT_USAGE, after a message, where there is none of this name */
int commands_run(const char *name, int argc, char **argv);

#endif
