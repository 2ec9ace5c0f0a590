/* Points that fill a square or a cube evenly, from the first on.
 *
 * source Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018: steps that are
 *        powers of 1/g, where g^(n+1) = g + 1 in n dimensions
 */
#ifndef APPS_TRUTH_EVEN_POINTS_H
#define APPS_TRUTH_EVEN_POINTS_H

#include <math.h>
#include <stdint.h>

static inline double truth_even_place(uint32_t i, double step)
{
    double place = 0.5 + i * step;
    return place - floor(place);
}

/* out  place: in [0, 1) */
static inline void truth_even_in_square(uint32_t i, double place[2])
{
    place[0] = truth_even_place(i, 0.7548776662466927);
    place[1] = truth_even_place(i, 0.5698402909980532);
}

static inline void truth_even_in_cube(uint32_t i, double place[3])
{
    place[0] = truth_even_place(i, 0.8191725133961645);
    place[1] = truth_even_place(i, 0.6710436067037893);
    place[2] = truth_even_place(i, 0.5497004779019703);
}

#endif
