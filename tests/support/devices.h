/* The devices that exist here, on which a list must have the same bits: executors, numbers of
 * threads, and every lane width that the build has and the processor runs. */
#ifndef TESTS_DEVICES_H
#define TESTS_DEVICES_H

#include "apps/frame/frame.h"

/* One device after the other: the reference executor first, with which the others are compared;
 * NULL after the last. The first call says as a TAP comment which there are, and which widths are
 * not here. */
const GpDeviceDesc *device_here(size_t number);

/* "fast lanes8 x3", executor, width and threads; valid until the next call. */
const char *device_name(const GpDeviceDesc *desc);

/* A device; fails the running test where there is none. */
GpDevice *device_open(const GpDeviceDesc *desc);

/* Runs a list on a device of its own; on the fast executor with two threads.
 * errors fails the running test where it does not run */
void run_list_on(const GpDeviceDesc *desc, const GpList *list);
void run_list(const GpList *list);

/* Hash of all targets of a list, colours and depths. */
uint64_t hash_targets(const GpList *list);

/* Runs a pass that clears its targets on every device, with run_list_on.
 * errors fails the running test, naming the seed, where one draws other bits than the first */
void run_seed_everywhere(const GpPass *pass, int seed);

/* Runs a list, or a frame's, on every device; each begins with the surfaces as they are now, and
 * leaves the same bits in all of them.
 * errors fails the running test, saying what was drawn, where one does not run, or draws other bits
 *        than the first */
void run_list_everywhere(const GpList *list, const char *what);
void run_everywhere(const Frame *frame);

#endif
