/* A seeded random source for tests: the same numbers on every machine. */
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H

#include <stdint.h>

typedef struct Random {
    uint64_t state;
} Random;

/* Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014. */
static inline uint64_t random_bits(Random *random)
{
    uint64_t z = random->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline uint32_t random_word(Random *random)
{
    return (uint32_t)(random_bits(random) >> 32);
}

/* Integer in [low, high]. */
static inline int32_t random_int(Random *random, int32_t low, int32_t high)
{
    uint64_t span = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)(low + (int64_t)(random_bits(random) % span));
}

/* Float in [low, high], on a grid of 2^-24 of the span. */
static inline float random_float(Random *random, float low, float high)
{
    float unit = (float)(random_bits(random) >> 40) * 0x1p-24f;
    return low + unit * (high - low);
}

/* The same as a double, of floats' bounds. */
static inline double random_between(Random *random, double low, double high)
{
    return (double)random_float(random, (float)low, (float)high);
}

#endif
