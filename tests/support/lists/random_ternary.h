/* A third draw of lots for a random list: ternary depth tests, apart from the others, whose lists
 * stay what they were. */
#ifndef TESTS_RANDOM_TERNARY_H
#define TESTS_RANDOM_TERNARY_H

#include "tests/support/random_list.h"

/* Gives most draws with depth the ternary test, with an epsilon from nothing to all, and many of
 * them a blend that adds; the list stays valid (gp_list_check). Never fails. */
bool random_ternary_add(uint64_t seed, RandomList *random);

#endif
