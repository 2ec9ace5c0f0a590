/* A fourth draw of lots for a random list: passes that sort their fragments, apart from the others,
 * whose lists stay what they were. */
#ifndef TESTS_RANDOM_ORDER_H
#define TESTS_RANDOM_ORDER_H

#include "tests/support/random_list.h"

/* Gives most passes an order by depth, half of these draws that leave depth and stencil alone, and
 * some draws a program with one colour a triangle; the list stays valid (gp_list_check). Never
 * fails. */
bool random_order_add(uint64_t seed, RandomList *random);

#endif
