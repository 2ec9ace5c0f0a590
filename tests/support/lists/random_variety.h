/* A second draw of lots for a random list: strips, fans and short indices instead of lists, other
 * types of vertices, X8R8G8B8 and L8, clears of rectangles, texels in memory of the caller's, and
 * memory under two names. Apart from the first, whose lists stay what they were. */
#ifndef TESTS_RANDOM_VARIETY_H
#define TESTS_RANDOM_VARIETY_H

#include "tests/support/random_list.h"

/* Changes a fresh list; it stays valid (gp_list_check).
 * returns false when memory is short */
bool random_variety_add(uint64_t seed, RandomList *random);

/* Whether the bytes between the rows of borrowed surfaces are as random_variety_add left them. */
bool random_variety_gaps_kept(const RandomList *random);

#endif
