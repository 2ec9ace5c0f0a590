/* What is run while calls fail: every command of the program, every technique by each kind of
 * method and every kind of file, with so little to do that a run takes milliseconds. */
#ifndef TESTS_FAULTS_COMMANDS_H
#define TESTS_FAULTS_COMMANDS_H

#include <stdbool.h>

typedef struct Command {
    const char *name;
    const char *line;    /* words; SCENES/ stands for the folder of scenes, ~ for a space */
    const char *needs;   /* names of fault_inputs that are to be run before; NULL: none */
    const char *outputs; /* the files that it writes, words too; NULL: none */

    const char *may_stay; /* a file that a run which failed may leave: a journal. NULL: none */
    /* what fails in a run that goes before: it goes on from that. NULL: nothing */
    const char *after;
    bool has_report; /* which tells what it could not read, with exit code 3 */
    bool varies;     /* times are in what it prints and writes */
} Command;

/* Files by their names and content, which are there before anything is run. Ends with a name of
 * NULL. */
extern const char *const fault_files[][2];

/* Run once in a folder, to make the files that others read. Ends with a name of NULL. */
extern const Command fault_inputs[];

/* Ends with a name of NULL. */
extern const Command fault_commands[];

#endif
