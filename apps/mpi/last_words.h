/* What is said when a run ends because a rank did: mpirun then ends all others by a signal, in
 * whose handler nothing may be asked of anyone. So rank 0 keeps what each is at where the handler
 * finds it. */
#ifndef APPS_MPI_LAST_WORDS_H
#define APPS_MPI_LAST_WORDS_H

#include "apps/mpi/hosts.h"

void last_words_begin(int rank, int count, const Host *hosts);

/* The item that a rank is at; "": none. */
void last_words_set(int rank, const char *item);

/* In the handler: one line of the rank that is gone, and of its item. Of ranks on other hosts
 * nothing is known but what they were at. */
void last_words_say(int number);

#endif
