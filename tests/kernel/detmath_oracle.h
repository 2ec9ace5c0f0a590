/* What the one-argument functions of pipeline/base/detmath.h are measured against: the exhaustive
 * check and the strided unit test walk the same table.
 *
 * The oracle is the C library in double: its own error, under one ulp of a double, is 2^-29 of what
 * is measured here.
 */
#ifndef GP_TESTS_DETMATH_ORACLE_H
#define GP_TESTS_DETMATH_ORACLE_H

#include "pipeline/base/base.h"
#include "pipeline/base/detmath.h"

#include <math.h>

/* --- the functions and their oracles ---------------------------------------------------------- */

typedef struct DetmathFunction {
    const char *name;
    flt (*lanes)(flt x);
    double (*oracle)(double x);
    double ulps;    /* largest error allowed */
    double least;   /* smallest ulp counted: 2^-25 beside zeros turns 2 ulp into 2^-24 */
    float domain;   /* the error counts for |x| <= domain */
    bool is_circle; /* finite arguments beyond the domain: only the range [-1, 1] is promised */
} DetmathFunction;

/* The two exact functions have an exact oracle: a double holds floor(x), and frc is one IEEE
 * subtraction of floats. */
static double frc_oracle(double x)
{
    float fraction = (float)x - floorf((float)x);
    return (double)fraction;
}

static double rcp_oracle(double x)
{
    return 1.0 / x;
}

static double rsq_oracle(double x)
{
    return 1.0 / sqrt(x);
}

static double log2_d3d_oracle(double x)
{
    return x == 0.0 ? -(double)FLT_MAX : log2(fabs(x));
}

#define LANES_OF(name)                                                                             \
    static flt lanes_##name(flt x)                                                                 \
    {                                                                                              \
        return math_##name(x);                                                                     \
    }
LANES_OF(floor)
LANES_OF(frc)
LANES_OF(rcp)
LANES_OF(rsq)
LANES_OF(exp2)
LANES_OF(log2)
LANES_OF(log2_d3d)
LANES_OF(sin)
LANES_OF(cos)

/* Half an ulp, and the oracle's own rounding. */
#define ROUNDED 0.5000001

/* clang-format off */
static const DetmathFunction detmath_functions[] = {
    { "floor",    lanes_floor,    floor,           0.0,     0.0,     INFINITY, false },
    { "frc",      lanes_frc,      frc_oracle,      0.0,     0.0,     INFINITY, false },
    { "rcp",      lanes_rcp,      rcp_oracle,      ROUNDED, 0.0,     INFINITY, false },
    { "rsq",      lanes_rsq,      rsq_oracle,      2.0,     0.0,     INFINITY, false },
    { "exp2",     lanes_exp2,     exp2,            2.0,     0.0,     INFINITY, false },
    { "log2",     lanes_log2,     log2,            2.0,     0.0,     INFINITY, false },
    { "log2_d3d", lanes_log2_d3d, log2_d3d_oracle, 2.0,     0.0,     INFINITY, false },
    { "sin",      lanes_sin,      sin,             2.0,     0x1p-25, 8192.0f,  true },
    { "cos",      lanes_cos,      cos,             2.0,     0x1p-25, 8192.0f,  true },
};
/* clang-format on */

/* --- one argument ----------------------------------------------------------------------------- */

/* The distance of neighbouring floats at value. */
static double ulp_at(double value)
{
    union {
        double d;
        uint64_t u;
    } pun = { .d = value };
    int64_t exponent = (int64_t)(pun.u >> 52 & 0x7ff);
    int64_t smallest = 1023 - 126; /* below it floats are evenly spaced */
    pun.u = (uint64_t)((exponent < smallest ? smallest : exponent) - 23) << 52;
    return pun.d;
}

/* Overflow begins at 2^128, which stands for infinity. */
static double within_floats(double value)
{
    double end = 0x1p128;
    return value > end ? end : value < -end ? -end : value;
}

/* Error of one result in ulp; infinite where a rule without a size is broken. */
static double detmath_error(const DetmathFunction *function, float x, float result)
{
    if (function->is_circle && !(fabsf(x) <= function->domain) && isfinite(x))
        return fabsf(result) <= 1.0f ? 0.0 : (double)INFINITY;
    double truth = function->oracle((double)x);
    if (isnan(truth) || isnan(result))
        return isnan(truth) && isnan(result) ? 0.0 : (double)INFINITY;
    if (function->is_circle && fabsf(result) > 1.0f)
        return (double)INFINITY;
    truth = within_floats(truth);
    double ulp = ulp_at(truth);
    return fabs(within_floats((double)result) - truth) /
           (ulp < function->least ? function->least : ulp);
}

#endif
