/* The functions of a shader's arithmetic unit: floor, fraction, reciprocals, powers, logarithms and
 * the circle, on lane vectors.
 *
 * Everything is built from + - * / sqrt, integer operations and selections, so every lane holds the
 * same bits for any lane count, compiler, optimisation level and machine. Requires contraction off
 * and gradual underflow on (R29, R50); the C library is never asked (R52), nor the processor's
 * estimates (R51).
 *
 * Accuracy is counted in ulp, the distance of neighbouring floats at the true result. The largest
 * errors over all 2^32 arguments, by tests/kernel/check_detmath.c:
 *
 *   floor and frc exact   rcp 0.50   rsq 1.50   exp2 1.28   log2 1.60
 *   sin 1.56   cos 1.54   for |x| <= 8192; beside their zeros an absolute error of 2^-24 counts
 *
 * A NaN argument gives a NaN, whose sign and payload are not promised. Denormals are numbers like
 * any other, as arguments and as results. Edge cases are listed at each function.
 *
 * The polynomials are our own minimax fits (Remez exchange at 160 bits). Their coefficients were
 * rounded to float from the lowest power up, the remaining ones fitted again after each rounding,
 * so that they also make good the rounding of those before them.
 */
#ifndef GP_DETMATH_H
#define GP_DETMATH_H

#include "pipeline/base/lanes.h"

#include <float.h>

/* x cut to [lowest, highest]; this order of arguments lets NaN pass. */
GP_INLINE flt math_between(flt x, float lowest, float highest)
{
    return flt_greater(flt_set(lowest), flt_lesser(flt_set(highest), x));
}

/* --- floor and fraction ----------------------------------------------------------------------- */

/* Largest integer not above x.
 * edges +-0, +-inf and every |x| >= 2^23 are returned as they are; floor(-denormal) = -1
 * source R50: exact */
GP_INLINE flt math_floor(flt x)
{
    return flt_floor(x);
}

/* x - floor(x), the IEEE difference kept: in [0, 1], and 1 for x in [-2^-25, 0).
 * edges frc(+-0) = 0; frc(+-inf) = NaN
 * source Direct3D frc */
GP_INLINE flt math_frc(flt x)
{
    return x - math_floor(x);
}

/* --- reciprocals ------------------------------------------------------------------------------ */

/* 1 / x, correctly rounded.
 * edges +-0 -> +-inf; +-inf -> +-0; |x| <= 2^-128 -> +-inf
 * source R50, R51 */
GP_INLINE flt math_rcp(flt x)
{
    return 1.0f / x;
}

/* 1 / sqrt(x) by two correctly rounded operations.
 * edges +-0 -> +-inf; inf -> 0; x < 0 -> NaN; denormals are exact arguments like any other
 * source R50, R51 */
GP_INLINE flt math_rsq(flt x)
{
    return 1.0f / flt_sqrt(x);
}

/* --- powers and logarithms -------------------------------------------------------------------- */

/* The sum with this constant of any |x| < 2^22 is x rounded to an integer, ties to even, which
 * stands in the low bits of the sum; subtracting the constant again gives it as a float. */
#define GP_ROUND_TO_INTEGER 0x1.8p23f

/* 2^n 2^f for x = n + f with n = round(x): 2^f, and in *n's low bits n. */
GP_INLINE flt math_exp2_parts(flt x, utg *n)
{
    flt sum = x + GP_ROUND_TO_INTEGER;
    flt f = x - (sum - GP_ROUND_TO_INTEGER);

    flt f2 = f * f;
    flt q01 = 0x1.62e430p-1f + 0x1.ebfbdep-3f * f;
    flt q23 = 0x1.c6afa8p-5f + 0x1.3b2d00p-7f * f;
    flt q45 = 0x1.5eeee6p-10f + 0x1.41b9f4p-13f * f;
    *n = (utg)sum;
    return 1.0f + f * (q01 + f2 * (q23 + f2 * q45));
}

/* 2^x.
 * edges +-0 -> 1; integers in [-149, 127] are exact; x >= 128 and inf -> inf; results below 2^-126
 * are denormals rounded once; x <= -150 and -inf -> 0
 * source ours: 2^x = 2^n 2^f with n = round(x), f in [-1/2, 1/2]; (2^f - 1) / f as a polynomial of
 * degree 5, minimax, error 2^-27.7 of 2^f */
GP_INLINE flt math_exp2(flt x)
{
    utg n;
    flt cut = math_between(x, -150.0f, 128.0f);
    flt power = math_exp2_parts(cut, &n);

    /* n goes straight into the exponent; at x = 128 that makes infinity. A result below the normal
     * floats is made 2^149 times as large and rounded to an integer, which is its bits: processors
     * are slow at products that are denormal, and a highlight fades through them into 0. */
    msk denormal = cut < -126.0f;
    utg exponent = (n << 23) + (utg)(denormal & (149 << 23));
    flt scaled = (flt)((utg)power + exponent);
    flt rounded = (flt)((utg)(scaled + 0x1p23f) - 0x4b000000u); /* the bits of 2^23 */
    return flt_select(x == x, flt_select(denormal, rounded, scaled), x);
}

/* 2^x where most of the time no lane is beside an edge: then there is nothing to cut or to
 * select. */
GP_INLINE flt math_exp2_mostly_normal(flt x)
{
    utg n;
    flt power = math_exp2_parts(x, &n);
    if (msk_any(~(flt_abs(x) <= 126.0f)))
        return math_exp2(x);
    return (flt)((utg)power + (n << 23));
}

/* log2 |x|, with the given value at 0; |inf| and NaN are their own logarithms.
 * source ours: |x| = 2^k (1 + r) with 1 + r in [sqrt(1/2), sqrt(2)), r exact;
 * log2(1 + r) = r + r q(r), q of degree 8, minimax, error 2^-24.8 of the logarithm. As the sum of
 * an exact r and a smaller product it is accurate beside the zero at 1 too, which pow lives on. */
GP_INLINE flt math_log2_of_size(flt x, float at_zero)
{
    flt size = flt_abs(x);
    msk denormal = size < FLT_MIN;
    itg bits = (itg)flt_select(denormal, size * 0x1p23f, size);
    itg above = bits - 0x3f3504f3; /* the bits of sqrt(1/2) */
    flt k = flt_from_itg((above >> 23) - (denormal & 23));
    flt r = (flt)(bits - (above & -0x800000)) - 1.0f;

    flt r2 = r * r;
    flt q12 = 0x1.ec7452p-2f * r - 0x1.715476p-1f;
    flt q34 = 0x1.26c3fcp-2f * r - 0x1.71596cp-2f;
    flt q56 = 0x1.bb45b0p-3f * r - 0x1.e9c3c4p-3f;
    flt q78 = 0x1.f687p-4f * r - 0x1.a6564ep-3f;
    flt q18 = (q12 + r2 * q34) + (r2 * r2) * (q56 + r2 * q78);
    flt log_of_rest = r + (0x1.c551d6p-2f * r + r2 * q18);

    flt result = flt_select(size <= FLT_MAX, k + log_of_rest, size);
    return flt_select(size == 0.0f, flt_set(at_zero), result);
}

/* log2 x.
 * edges powers of two are exact; log2(1) = +0; +-0 -> -inf; inf -> inf; x < 0 -> NaN
 * source math_log2_of_size */
GP_INLINE flt math_log2(flt x)
{
    return flt_select(x < 0.0f, flt_set(__builtin_nanf("")),
                      math_log2_of_size(x, -__builtin_inff()));
}

/* log2 |x|, as Direct3D's log.
 * edges powers of two are exact; +-0 -> -FLT_MAX; +-inf -> inf
 * source math_log2_of_size; Direct3D log */
GP_INLINE flt math_log2_d3d(flt x)
{
    return math_log2_of_size(x, -FLT_MAX);
}

/* |x|^y, which is 2^(y log2 |x|), within 2^-15 of any normal result; the error grows with the
 * exponent of the result, from 2^-22 near 1 to 2^-16 at the ends of the range.
 * edges follow from the formula, with no case of their own:
 *       pow(x, 0) = 1 for finite x, 0 too; NaN for x = +-inf (R30: 0 * inf = NaN);
 *       pow(+-1, y) = 1 for finite y; NaN for y = +-inf, for the same reason;
 *       pow(0, y) = 0 for y >= 2^-120 and inf for y <= -2^-120; in between 2^(-FLT_MAX y);
 *       pow(inf, y) = inf for y > 0, 0 for y < 0;
 *       pow(x, inf) = 0 for |x| < 1, inf for |x| > 1; the other way round for -inf
 * source Direct3D pow: abs(src0)^src1 with 15 bits */
GP_INLINE flt math_pow(flt x, flt y)
{
    return math_exp2(y * math_log2_d3d(x));
}

/* --- the circle ------------------------------------------------------------------------------- */

/* sin(size + quarters pi/2) for size >= 0.
 * source ours: size = n pi/2 + r, |r| <= pi/4 and a little. pi/2 is cut into 11 + 11 + 24 bits, so
 * for n <= 8191 (13 bits) the first two products are exact, and so are the first two differences;
 * what is left wrong is the rounding of the last one and 2^-46 of size. The clamp matters only for
 * sizes too large to be reduced. sin r = r + r^3 s(r^2) and cos r = 1 - r^2/2 + r^4 c(r^2), both of
 * degree 2, minimax on |r| <= 0.787, errors 2^-27.8 of sin and 2^-32.9 of cos. Each call makes both
 * and takes one by the quarter, so a sine and a cosine of the same value cost one. */
GP_INLINE flt math_sin_from_quarter(flt size, uint32_t quarters)
{
    flt sum = size * 0x1.45f306p-1f + GP_ROUND_TO_INTEGER;
    flt n = sum - GP_ROUND_TO_INTEGER;
    flt r = size - n * 0x1.92p+0f;
    r = r - n * 0x1.fb4p-12f;
    r = r - n * 0x1.4442d2p-24f;
    r = math_between(r, -0.787f, 0.787f);

    flt r2 = r * r;
    flt r4 = r2 * r2;
    flt s = (0x1.1106ccp-7f * r2 - 0x1.555544p-3f) - 0x1.9920e4p-13f * r4;
    flt c = (0x1.55554ap-5f - 0x1.6c0c26p-10f * r2) + 0x1.99e714p-16f * r4;
    flt sine = r + (r * r2) * s;
    flt cosine = 1.0f - (0.5f * r2 - r4 * c);

    utg quarter = (utg)sum + quarters; /* odd: the other function; 2 and 3 of 4: negative */
    flt value = flt_select(-(msk)(quarter & 1), cosine, sine);
    return (flt)((utg)value ^ (quarter << 30 & 0x80000000));
}

/* sin x.
 * edges +-0 and denormals are returned as they are; sin(-x) = -sin(x); +-inf -> NaN.
 *       |x| <= 8192 is the domain. Up to 2^22 the error stays below 2^-22 of x; beyond it the
 *       result only is finite, the same everywhere, and, as always, in [-1, 1]
 * source math_sin_from_quarter */
GP_INLINE flt math_sin(flt x)
{
    itg sign = (itg)x & INT32_MIN;
    return (flt)((itg)math_sin_from_quarter(flt_abs(x), 0) ^ sign);
}

/* cos x.
 * edges +-0 and denormals -> 1; cos(-x) = cos(x); +-inf -> NaN; beyond |x| = 8192 as sin
 * source math_sin_from_quarter */
GP_INLINE flt math_cos(flt x)
{
    return math_sin_from_quarter(flt_abs(x), 1);
}

/* --- one value at a time: the same bits as one lane, for code that has no lanes --------------- */

float gp_exp2(float x);
float gp_log2(float x); /* math_log2: 0 -> -inf, x < 0 -> NaN */
float gp_pow(float x, float y);
float gp_sin(float x);
float gp_cos(float x);

#endif
