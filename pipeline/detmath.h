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
 *   rcp 0.50   rsq LLL   exp2 LLL   log2 LLL   sin LLL   cos LLL (the last two for |x| <= 8192;
 *   beside the zeros of log2, sin and cos an absolute error of 2^-24 counts instead)
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

#include "pipeline/lanes.h"

#include <float.h>
#include <math.h> /* INFINITY and NAN only */

/* --- floor and fraction ----------------------------------------------------------------------- */

/* Largest integer not above x.
 * edges +-0, +-inf and every |x| >= 2^23 are returned as they are; floor(-denormal) = -1
 * source R50: exact */
GP_INLINE flt math_floor(flt x)
{
    /* Adding 2^23 to a size below it leaves no place for a fraction: the sum is rounded to even. */
    itg sign = (itg)x & INT32_MIN;
    flt size = (flt)((itg)x ^ sign);
    flt nearest = (flt)((itg)((size + 0x1p23f) - 0x1p23f) | sign);
    flt one_if_above = (flt)((nearest > x) & (itg)flt_set(1.0f));
    return flt_select(size < 0x1p23f, nearest - one_if_above, x);
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

/* 2^x.
 * edges +-0 -> 1; integers in [-149, 127] are exact; x >= 128 and inf -> inf; results below 2^-126
 * are denormals rounded once; x <= -150 and -inf -> 0
 * source ours: 2^x = 2^n 2^f with n = round(x), f in [-1/2, 1/2]; (2^f - 1) / f as a polynomial of
 * degree 5, minimax, error 2^-27.7 of 2^f */
GP_INLINE flt math_exp2(flt x)
{
    x = flt_lesser(flt_set(128.0f), x); /* this order of arguments lets NaN pass */
    x = flt_greater(flt_set(-150.0f), x);
    flt sum = x + GP_ROUND_TO_INTEGER;
    flt f = x - (sum - GP_ROUND_TO_INTEGER);

    flt f2 = f * f;
    flt q01 = 0x1.62e430p-1f + 0x1.ebfbdep-3f * f;
    flt q23 = 0x1.c6afa8p-5f + 0x1.3b2d00p-7f * f;
    flt q45 = 0x1.5eeee6p-10f + 0x1.41b9f4p-13f * f;
    flt power = 1.0f + f * (q01 + f2 * (q23 + f2 * q45));

    /* 2^n reaches beyond the exponents of a float, its two halves do not; only the second product
     * can round. The shifts drop all of sum but n. A NaN stays one through both products. */
    utg half = (utg)((itg)sum >> 1);
    utg rest = (utg)sum - half;
    return power * (flt)((half << 23) + 0x3f800000) * (flt)((rest << 23) + 0x3f800000);
}

/* log2 |x|, with the given value at 0; |inf| and NaN are their own logarithms.
 * source ours: |x| = 2^k (1 + r) with 1 + r in [sqrt(1/2), sqrt(2)), r exact;
 * log2(1 + r) = r + r q(r), q of degree 8, minimax, error 2^-24.8 of the logarithm. As the sum of
 * an exact r and a smaller product it is accurate beside the zero at 1 too, which pow lives on. */
GP_INLINE flt log2_of_size(flt x, float at_zero)
{
    flt size = flt_abs(x);
    msk denormal = size < FLT_MIN;
    itg bits = (itg)flt_select(denormal, size * 0x1p23f, size);
    itg above = bits - 0x3f3504f3; /* the bits of sqrt(1/2) */
    flt k = flt_from_itg((above >> 23) - (denormal & 23));
    flt r = (flt)(bits - (above & -0x800000)) - 1.0f;

    flt r2 = r * r;
    flt q01 = 0x1.c551d6p-2f - 0x1.715476p-1f * r;
    flt q23 = 0x1.ec7452p-2f - 0x1.71596cp-2f * r;
    flt q45 = 0x1.26c3fcp-2f - 0x1.e9c3c4p-3f * r;
    flt q678 = 0x1.bb45b0p-3f + r * (0x1.f687p-4f * r - 0x1.a6564ep-3f);
    flt q = (q01 + r2 * q23) + (r2 * r2) * (q45 + r2 * q678);

    flt result = flt_select(size <= FLT_MAX, k + (r + r * q), size);
    return flt_select(size == 0.0f, flt_set(at_zero), result);
}

/* log2 x.
 * edges powers of two are exact; log2(1) = +0; +-0 -> -inf; inf -> inf; x < 0 -> NaN
 * source log2_of_size */
GP_INLINE flt math_log2(flt x)
{
    return flt_select(x < 0.0f, flt_set(NAN), log2_of_size(x, -INFINITY));
}

/* log2 |x|, as Direct3D's log.
 * edges powers of two are exact; +-0 -> -FLT_MAX; +-inf -> inf
 * source log2_of_size; Direct3D log */
GP_INLINE flt math_log2_d3d(flt x)
{
    return log2_of_size(x, -FLT_MAX);
}

/* |x|^y, which is 2^(y log2 |x|), within 2^-15 of any normal result; the error grows with the
 * exponent of the result, from 2^-22 near 1 to PPP at the ends of the range.
 * edges follow from the formula, with no case of their own:
 *       pow(x, 0) = 1 for finite x, 0 too, and NaN for x = inf (R30: 0 * inf = NaN);
 *       pow(1, y) = 1 for finite y and NaN for y = +-inf;
 *       pow(0, y) = 0 for y >= 2^-120 and inf for y <= -2^-120; in between 2^(-FLT_MAX y);
 *       pow(inf, y) = inf for y > 0, 0 for y < 0;
 *       pow(x, inf) = 0 for |x| < 1, inf for |x| > 1; the other way round for -inf
 * source Direct3D pow: abs(src0)^src1 with 15 bits */
GP_INLINE flt math_pow(flt x, flt y)
{
    return math_exp2(y * math_log2_d3d(x));
}

/* --- the circle ------------------------------------------------------------------------------- */

/* sin(x - quarters pi/2), where the difference is within about pi/2 of 0 and the sign is that of
 * the lowest bit of flips. For |quarters| <= 5215 (13 bits): pi/2 is cut into 11 + 11 + 24 bits, so
 * the first two products are exact, and for |x| >= pi/2 so are the first two differences. What is
 * left wrong is 2^-46 of x and the rounding of the last difference. All three parts are positive,
 * which keeps -0. The clamp matters only for arguments too large to be reduced.
 * source ours: sin r = r + r^3 s(r^2), s of degree 3, minimax on |r| <= 1.572, error 2^-27.2 */
GP_INLINE flt sin_after_quarters(flt x, flt quarters, flt flips)
{
    flt r = x - quarters * 0x1.92p+0f;
    r = r - quarters * 0x1.fb4p-12f;
    r = r - quarters * 0x1.4442d2p-24f;
    r = flt_lesser(flt_set(1.572f), r);
    r = flt_greater(flt_set(-1.572f), r);
    r = (flt)((utg)r ^ ((utg)flips << 31));

    flt r2 = r * r;
    flt s01 = 0x1.110edap-7f * r2 - 0x1.55554cp-3f;
    flt s23 = 0x1.5dc8c6p-19f * r2 - 0x1.9f70eep-13f;
    return r + (r * r2) * (s01 + (r2 * r2) * s23);
}

/* sin x.
 * edges +-0 and denormals are returned as they are; sin(-x) = -sin(x); +-inf -> NaN.
 *       |x| <= 8192 is the domain; up to 2^22 the error grows to a few ulp of x; beyond it the
 *       result only is finite, the same everywhere, and in [-1, 1]
 * source sin_after_quarters, with the nearest multiple of pi */
GP_INLINE flt math_sin(flt x)
{
    flt sum = x * 0x1.45f306p-2f + GP_ROUND_TO_INTEGER;
    flt halves = sum - GP_ROUND_TO_INTEGER;
    return sin_after_quarters(x, halves + halves, sum);
}

/* cos x.
 * edges +-0 and denormals -> 1; cos(-x) = cos(x); +-inf -> NaN; beyond |x| = 8192 as sin
 * source sin_after_quarters, with the nearest odd multiple of pi/2: cos is accurate at its zeros */
GP_INLINE flt math_cos(flt x)
{
    flt size = flt_abs(x);
    flt sum = (size * 0x1.45f306p-2f - 0.5f) + GP_ROUND_TO_INTEGER;
    flt halves = sum - GP_ROUND_TO_INTEGER;
    return -sin_after_quarters(size, halves + halves + 1.0f, sum);
}

/* --- one value at a time: the same bits as one lane, for code that has no lanes ----------------- */

float gp_exp2(float x);
float gp_log2(float x); /* math_log2: 0 -> -inf, x < 0 -> NaN */
float gp_pow(float x, float y);
float gp_sin(float x);
float gp_cos(float x);

#endif
