/* The eight compare functions, for alpha, depth and stencil alike (R30). */
#ifndef GP_COMPARE_H
#define GP_COMPARE_H

#include "pipeline/resources/state.h"

/* How two values relate, and which relations each function accepts. */
enum { GP_IS_LESS = 1, GP_IS_EQUAL = 2, GP_IS_GREATER = 4, GP_IS_UNORDERED = 8 };

static inline bool gp_compare_accepts(GpCompare test, unsigned relation)
{
    static const uint8_t accepted[GP_COMPARES] = {
        [GP_ALWAYS] = 15,
        [GP_NEVER] = 0,
        [GP_LESS] = GP_IS_LESS,
        [GP_EQUAL] = GP_IS_EQUAL,
        [GP_LESS_EQUAL] = GP_IS_LESS | GP_IS_EQUAL,
        [GP_GREATER] = GP_IS_GREATER,
        [GP_NOT_EQUAL] = GP_IS_LESS | GP_IS_GREATER | GP_IS_UNORDERED,
        [GP_GREATER_EQUAL] = GP_IS_GREATER | GP_IS_EQUAL,
    };
    return accepted[test] & relation;
}

static inline bool gp_compare_codes(GpCompare test, uint32_t a, uint32_t b)
{
    return gp_compare_accepts(test, a < b ? GP_IS_LESS : a > b ? GP_IS_GREATER : GP_IS_EQUAL);
}

static inline bool gp_compare_floats(GpCompare test, float a, float b)
{
    return gp_compare_accepts(test, a < b    ? GP_IS_LESS
                                    : a > b  ? GP_IS_GREATER
                                    : a == b ? GP_IS_EQUAL
                                             : GP_IS_UNORDERED);
}

#endif
