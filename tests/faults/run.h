/* One run of a command in a folder of its own, and what it left there. */
#ifndef TESTS_FAULTS_RUN_H
#define TESTS_FAULTS_RUN_H

#include "tests/faults/commands.h"
#include "tests/faults/fail_calls.h"

#include <limits.h>
#include <stdint.h>

enum { MOST_OUTPUTS = 8 };

/* The program and the library that lets its calls fail, and where scenes are. */
typedef struct Runner {
    char program[PATH_MAX], library[PATH_MAX], scenes[PATH_MAX];
} Runner;

typedef struct Run {
    int status; /* as waitpid says */
    char says[4096];
    uint64_t printed;                                     /* hash of stdout */
    uint64_t before[MOST_OUTPUTS], written[MOST_OUTPUTS]; /* of output files; 0: no file */
    char left[NAME_MAX + 1]; /* a file that should not be there; "": none */
    unsigned long calls[FAIL_KINDS];
} Run;

/* Makes a folder below /tmp with fault_files, and what fault_inputs of these names make. */
void run_folder_make(const Runner *runner, const char *needed, char folder[64]);

/* Goes there. */
void run_folder_enter(const char *folder);

void run_folder_remove(const char *folder);

/* Runs a command there. What an earlier run has written is removed first, and other content stands
 * in its outputs' place; where it is one that goes on, what it goes on from is made.
 * in     fail: "alloc:17", see fail_calls.c; NULL: nothing fails */
void run_command(const Runner *runner, const Command *command, const char *fail, Run *run);

/* How many files a command writes. */
int run_outputs(const Command *command);

#endif
