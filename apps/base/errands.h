/* A second thread that does errands one after the other, in the order in which they were given. */
#ifndef APPS_BASE_ERRANDS_H
#define APPS_BASE_ERRANDS_H

/* NULL stands for no second thread: whoever gives an errand does it then. */
typedef struct Errands Errands;

/* in: context: the errand's own, which it frees */
typedef void ErrandFn(void *context);

/* returns NULL where there is no memory for a thread. owns: the caller, until errands_end */
Errands *errands_begin(void);

/* Gives an errand, and waits while a few are there that were not begun. */
void errands_give(Errands *errands, ErrandFn *errand, void *context);

/* Waits until all are done: what they wrote may be read. */
void errands_wait(Errands *errands);

void errands_end(Errands **errands); /* when all are done. NULL-safe, sets NULL */

#endif
