/* The bits of techniques' pictures: one picture for every executor, number of threads and lane
 * width. */
#ifndef TESTS_SWEEP_BITS_H
#define TESTS_SWEEP_BITS_H

#include "apps/techniques/technique.h"

enum { SWEEP_ROWS = 64 };

/* Draws each text of options on every device that is here, the model opened anew for each.
 * out    hashes: of all targets of the frame, text by text
 * errors fails the running test where a device draws other bits */
void texts_are_one_picture(const Technique *technique, const TechniqueInput *input,
                           const char *const *texts, size_t count, uint64_t *hashes);

/* Draws one text of each row of the sweep of a technique's first experiment, as
 * texts_are_one_picture does.
 * out    hashes: of all targets of the frame, row by row
 * errors fails the running test where a device draws other bits */
void sweep_is_one_picture(const Technique *technique, const TechniqueInput *input,
                          uint64_t hashes[SWEEP_ROWS]);

#endif
