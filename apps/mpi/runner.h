/* Items drawn by all ranks: rank 0 hands them out, draws too, and takes what comes. */
#ifndef APPS_MPI_RUNNER_H
#define APPS_MPI_RUNNER_H

#include "apps/mpi/hosts.h"

#include <stdbool.h>

/* in hosts: of each rank; kept */
void runner_begin(int rank, int count, const Host *hosts);

/* On ranks other than 0: waits for rank 0's first word; false: there is nothing to do. */
bool runner_wait_for_start(void);

/* As report_to's: what a rank's command has failed with, for rank 0. */
void runner_note_failure(int code, const char *line);

/* At exit of rank 0, and of another. */
void runner_dismiss(void);
void runner_say_failure(void);

/* In a signal's handler, on any rank: which rank is gone, and what it was at. */
void runner_say_last_words(int number);

#endif
