/* The subcommands of `glasspipe` but those of techniques (technique_command.h), one file each, and
 * what they all share: the exit codes. */
#ifndef APPS_COMMANDS_COMMANDS_H
#define APPS_COMMANDS_COMMANDS_H

/* What the program tells its caller. */
enum {
    EXIT_DONE = 0,
    EXIT_DIFFERS = 1,  /* compared, and the pictures differ; or a check failed */
    EXIT_USAGE = 2,    /* a wrong command, option or argument */
    EXIT_INPUT = 3,    /* an input file that is missing, broken, or asks for the impossible */
    EXIT_INTERNAL = 4, /* no memory, or the output could not be written */
};

/* A subcommand: argv[0] is "glasspipe NAME", for messages; returns one of the codes above. */
typedef int CommandFn(int argc, char **argv);

CommandFn cmd_render;
CommandFn cmd_compare;
CommandFn cmd_explain;
CommandFn cmd_pixel;
CommandFn cmd_bench;
CommandFn cmd_chart;

#endif
