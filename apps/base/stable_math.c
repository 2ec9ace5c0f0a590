#include "apps/base/stable_math.h"

#include <math.h>
#include <stdbool.h>

/* ln 2 in two parts: products of the first with whole numbers of up to 11 bits are exact. */
static const double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;

/* x = n ln 2 + r with |r| <= ln 2 / 2; e^r by its series, whose next term is below 2^-57. */
double stable_exp(double x)
{
    if (!(x > -745.2))
        return isnan(x) ? x : 0;
    if (x > 709.8)
        return HUGE_VAL;
    const double n = floor(x / (ln2_high + ln2_low) + 0.5);
    const double r = (x - n * ln2_high) - n * ln2_low;
    double sum = 1;
    for (int i = 13; i > 0; i--)
        sum = 1 + sum * r / i;
    return ldexp(sum, (int)n);
}

/* x = 2^e m with m in [sqrt 1/2, sqrt 2]; ln m = 2 artanh z, z = (m - 1) / (m + 1), by its series:
 * z^2 < 0.0295, so that the first term left out is below 2^-58 of the sum. */
double stable_log(double x)
{
    if (!(x > 0))
        return x == 0 ? -HUGE_VAL : (double)NAN;
    if (isinf(x))
        return x;
    int e;
    double m = frexp(x, &e);
    if (m < 0x1.6a09e667f3bcdp-1) {
        m *= 2;
        e--;
    }
    const double z = (m - 1) / (m + 1), z2 = z * z;
    double sum = 0;
    for (int i = 23; i > 1; i -= 2)
        sum = (sum + 1.0 / i) * z2;
    return e * ln2_high + (2 * z + (2 * z * sum + e * ln2_low));
}

double stable_pow(double x, double y)
{
    if (y == 0)
        return 1;
    return x == 0 && y > 0 ? 0 : stable_exp(y * stable_log(x));
}

/* atan t for t in [0, 1]: above tan(pi / 8) as pi / 4 + atan((t - 1) / (t + 1)); by its series, in which
 * t^2 <= 0.1716, so that the first term left out is below 2^-57 of the sum. */
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
