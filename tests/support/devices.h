/* Lists on devices that must agree: both executors, several numbers of threads, every lane
 * width. */
#ifndef TESTS_DEVICES_H
#define TESTS_DEVICES_H

#include "apps/frame/frame.h"

/* Runs a list on the fast executor.
 * errors fails the running test where it does not run */
void run_list(const GpList *list);

/* Runs a work on every device that the processor and the build have; each begins with the surfaces
 * as they are now, and leaves the same bits in all of them.
 * errors fails the running test where one does not run, or draws other bits than the first */
void run_everywhere(const Frame *frame);

#endif
