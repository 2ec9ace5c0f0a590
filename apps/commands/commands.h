/* The subcommands of `glasspipe`, one file each. */
#ifndef APPS_COMMANDS_COMMANDS_H
#define APPS_COMMANDS_COMMANDS_H

/* A subcommand: argv[0] is "glasspipe NAME", for messages; returns an exit code. */
typedef int CommandFn(int argc, char **argv);

CommandFn cmd_render;
CommandFn cmd_compare;
CommandFn cmd_test;
CommandFn cmd_explain;
CommandFn cmd_pixel;
CommandFn cmd_inspect;
CommandFn cmd_bench;
CommandFn cmd_shader;
CommandFn cmd_chart;
CommandFn cmd_warp_walk;
CommandFn cmd_warp_capture;

#endif
