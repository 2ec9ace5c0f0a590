/* Exponentials, logarithms, powers and angles in double, with the same bits on every machine: those
 * of the C library differ between its versions and between processors. Made of + - * / in a stated
 * order and of scaling by powers of two, which is exact.
 *
 * stable_exp is within 1.5 and stable_log within 2 units in the last place; stable_pow has a
 * relative error of at most 1e-14 where the logarithm of its result is within 40; stable_atan2 is
 * within 3 units
 * in the last place. */
#ifndef APPS_BASE_STABLE_MATH_H
#define APPS_BASE_STABLE_MATH_H

#include <stdint.h>

/* Two numbers side by side. */
typedef double StablePair __attribute__((vector_size(16)));
typedef int64_t StablePairBits __attribute__((vector_size(16)));

/* a where the mask's bits are set, else b. */
static inline StablePair stable_choose(StablePairBits mask, StablePair a, StablePair b)
{
    return (StablePair)((mask & (StablePairBits)a) | (~mask & (StablePairBits)b));
}

/* e^x; 0 below -745, infinite above 709, NaN of NaN. */
double stable_exp(double x);

/* Natural logarithm of x > 0, denormals too; -inf of 0, NaN below it, inf of inf. */
double stable_log(double x);

/* x^y for x >= 0: exp(y log x); 1 for y = 0, else 0 for x = 0 and y > 0. */
double stable_pow(double x, double y);

/* Several of them, with the bits that each has alone, where x is 0 or normal, and so is the result.
 * Each waits for divisions one after the other, during which a processor does those of the
 * others. */
StablePair stable_pow_pair(StablePair x, StablePair y);
void stable_pow_pairs(const StablePair x[3], double y, StablePair power[3]);

/* The angle of (x, y) in radians, -pi..pi, as atan2 has it; 0 of (0, 0). Both finite. */
double stable_atan2(double y, double x);

#endif
