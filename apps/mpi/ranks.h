/* The ranks of a run: who they are, whether they are alike, and what each does. */
#ifndef APPS_MPI_RANKS_H
#define APPS_MPI_RANKS_H

/* Joins the other ranks, and has them draw items (items_set_runner). All draw a test and compare
 * it.
 * returns on rank 0 an exit code, after a message where it is not 0: another version, or other
 *        bits, on a rank that is named */
int ranks_begin(int *argc, char ***argv);

/* On rank 0 true at once; on others true when rank 0 has come to work for them, false when it has
 * none. */
int ranks_wait_for_work(void);

#endif
