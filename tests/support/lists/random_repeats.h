/* Random lists in which passes draw again what earlier ones drew, with other states, textures and
 * pixel shaders: as peeling does. */
#ifndef TESTS_RANDOM_REPEATS_H
#define TESTS_RANDOM_REPEATS_H

#include "tests/support/random_list.h"

/* Makes passes of the list of a seed repeat earlier ones; it stays valid. */
void random_repeats_add(uint64_t seed, RandomList *random);

#endif
