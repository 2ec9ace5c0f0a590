/* What the programs `glasspipe' and `glasspipe-mpi' have in common. */
#ifndef APPS_PROGRAM_H
#define APPS_PROGRAM_H

/* Signals, memory that runs out, output that does not arrive: before anything else. */
void program_begin(void);

/* Runs the subcommand of the command line. returns the program's exit code */
int program_run(int argc, char **argv);

/* Called by the handler of a signal that ends the program, which may come at any moment; NULL:
 * nothing. */
void program_set_last_words(void (*say)(int number));

#endif
