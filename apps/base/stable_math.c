#include "apps/base/stable_math.h"

#include "pipeline/base/lanes/types.h"

#include <math.h>
#include <stdbool.h>

/* ln 2 in two parts: products of the first with whole numbers of up to 11 bits are exact. */
static const double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;

/* --- side by side ----------------------------------------------------------------------------- */

/* Pairs that are worked on in turns: one, or as many as a colour has channels. */
enum { MOST = 3 };

#define EACH GP_UNROLL for (int k = 0; k < count; k++)

/* For |x| < 2^31. */
static StablePairBits floor_of(StablePair x)
{
    const StablePairBits cut = __builtin_convertvector(x, StablePairBits);
    return cut + (__builtin_convertvector(cut, StablePair) > x);
}

/* x = n ln 2 + r with |r| <= ln 2 / 2; e^r by its series, whose next term is below 2^-57. */
GP_INLINE void exp_of_rest(int count, const StablePair *x, StablePair *sum, StablePairBits *n)
{
    StablePair r[MOST];
    EACH
    {
        n[k] = floor_of(x[k] / (ln2_high + ln2_low) + 0.5);
        const StablePair whole = __builtin_convertvector(n[k], StablePair);
        r[k] = (x[k] - whole * ln2_high) - whole * ln2_low;
        sum[k] = (StablePair){ 1, 1 };
    }
    for (int i = 13; i > 0; i--)
        EACH sum[k] = 1 + sum[k] * r[k] / (double)i;
}

/* ln(2^e m) for m in [1/2, 1]: of [sqrt 1/2, sqrt 2] it is made first; ln m = 2 artanh z, z = (m -
 * 1) / (m + 1), by its series: z^2 < 0.0295, so that the first term left out is below 2^-58 of the
 * sum. */
GP_INLINE void log_of_parts(int count, const StablePair *m, const StablePairBits *e,
                            StablePair *log)
{
    StablePair whole[MOST], z[MOST], z2[MOST], sum[MOST];
    EACH
    {
        const StablePairBits is_low = m[k] < 0x1.6a09e667f3bcdp-1;
        const StablePair near_one = stable_choose(is_low, m[k] * 2, m[k]);
        whole[k] = __builtin_convertvector(e[k] + is_low, StablePair);
        z[k] = (near_one - 1) / (near_one + 1);
        z2[k] = z[k] * z[k];
        sum[k] = (StablePair){ 0, 0 };
    }
    for (int i = 23; i > 1; i -= 2)
        EACH sum[k] = (sum[k] + 1.0 / i) * z2[k];
    EACH log[k] = whole[k] * ln2_high + (2 * z[k] + (2 * z[k] * sum[k] + whole[k] * ln2_low));
}

GP_INLINE void pow_of_pairs(int count, const StablePair *x, const StablePair *y, StablePair *power)
{
    enum { FRACTION = 52, BIAS = 1023 };
    const int64_t half = (int64_t)(BIAS - 1) << FRACTION, all = ((int64_t)1 << FRACTION) - 1;
    StablePair m[MOST], log[MOST], rest[MOST];
    StablePairBits e[MOST], n[MOST];
    EACH
    {
        const StablePairBits bits = (StablePairBits)x[k];
        m[k] = (StablePair)((bits & all) | half);
        e[k] = (bits >> FRACTION) - (BIAS - 1);
    }
    log_of_parts(count, m, e, log);
    EACH log[k] *= y[k];
    exp_of_rest(count, log, rest, n);
    EACH
    {
        const StablePair zero = { 0, 0 };
        const StablePair scaled = rest[k] * (StablePair)((n[k] + BIAS) << FRACTION);
        power[k] = stable_choose(y[k] == zero, zero + 1, stable_choose(x[k] == zero, zero, scaled));
    }
}

StablePair stable_pow_pair(StablePair x, StablePair y)
{
    StablePair power;
    pow_of_pairs(1, &x, &y, &power);
    return power;
}

void stable_pow_pairs(const StablePair x[3], double y, StablePair power[3])
{
    const StablePair same[3] = { { y, y }, { y, y }, { y, y } };
    pow_of_pairs(3, x, same, power);
}

/* --- alone ------------------------------------------------------------------------------------ */

double stable_exp(double x)
{
    if (!(x > -745.2))
        return isnan(x) ? x : 0;
    if (x > 709.8)
        return HUGE_VAL;
    const StablePair pair = { x, x };
    StablePair rest;
    StablePairBits n;
    exp_of_rest(1, &pair, &rest, &n);
    return ldexp(rest[0], (int)n[0]);
}

double stable_log(double x)
{
    if (!(x > 0))
        return x == 0 ? -HUGE_VAL : (double)NAN;
    if (isinf(x))
        return x;
    int e;
    const double fraction = frexp(x, &e);
    const StablePair m = { fraction, fraction };
    const StablePairBits both = { e, e };
    StablePair log;
    log_of_parts(1, &m, &both, &log);
    return log[0];
}

double stable_pow(double x, double y)
{
    if (y == 0)
        return 1;
    return x == 0 && y > 0 ? 0 : stable_exp(y * stable_log(x));
}

/* --- angles ----------------------------------------------------------------------------------- */

/* atan t for t in [0, 1]: above tan(pi / 8) as pi / 4 + atan((t - 1) / (t + 1)); by its series, in
 * which t^2 <= 0.1716, so that the first term left out is below 2^-57 of the sum. */
static double atan_of_share(double t)
{
    const double quarter = 0x1.921fb54442d18p-1;
    const bool is_large = t > 0x1.a827999fcef32p-2;
    const double z = is_large ? (t - 1) / (t + 1) : t, z2 = z * z;
    double sum = 0;
    for (int i = 43; i > 1; i -= 2)
        sum = (1.0 / i - sum) * z2;
    const double angle = z - z * sum;
    return is_large ? quarter + angle : angle;
}

double stable_atan2(double y, double x)
{
    const double half = 0x1.921fb54442d18p+0, whole = 0x1.921fb54442d18p+1;
    const double up = fabs(y), right = fabs(x);
    if (up == 0 && right == 0)
        return 0;
    double angle = up > right ? half - atan_of_share(right / up) : atan_of_share(up / right);
    if (x < 0)
        angle = whole - angle;
    return y < 0 ? -angle : angle;
}
