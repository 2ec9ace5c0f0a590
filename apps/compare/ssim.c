#include "apps/compare/ssim.h"

#include "apps/base/stable_math.h"

#include <math.h>
#include <string.h>

/* Gaussian of sigma 1.5 at -5..5, normalised to sum 1. */
static void gaussian(double weight[SSIM_WINDOW])
{
    double sum = 0;
    for (int i = 0; i < SSIM_WINDOW; i++) {
        double d = i - SSIM_WINDOW / 2;
        weight[i] = stable_exp(-d * d / (2 * 1.5 * 1.5));
        sum += weight[i];
    }
    for (int i = 0; i < SSIM_WINDOW; i++)
        weight[i] /= sum;
}

static double luminance(const Picture *picture, uint32_t x, uint32_t y)
{
    const size_t index = (size_t)y * picture->width + x;
    const float *v = picture->values + index * (size_t)picture->channels;
    if (picture->channels < 3)
        return (double)v[0];
    return 0.2126 * (double)v[0] + 0.7152 * (double)v[1] + 0.0722 * (double)v[2];
}

/* Weighted moments of a window: means of a, b, aa, bb, ab. */
typedef struct Moments {
    double a, b, aa, bb, ab;
} Moments;

static void add_weighted(Moments *sum, double weight, const Moments *m)
{
    sum->a += weight * m->a;
    sum->b += weight * m->b;
    sum->aa += weight * m->aa;
    sum->bb += weight * m->bb;
    sum->ab += weight * m->ab;
}

/* One column of a window, from row y down. */
static Moments column_moments(const Picture *a, const Picture *b, const double *weight, uint32_t x,
                              uint32_t y)
{
    Moments m = { 0 };
    for (uint32_t i = 0; i < SSIM_WINDOW; i++) {
        double va = luminance(a, x, y + i), vb = luminance(b, x, y + i);
        add_weighted(&m, weight[i], &(Moments){ va, vb, va * va, vb * vb, va * vb });
    }
    return m;
}

static double similarity(const Moments *m)
{
    const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    double variance_a = m->aa - m->a * m->a, variance_b = m->bb - m->b * m->b;
    double covariance = m->ab - m->a * m->b;
    return (2 * m->a * m->b + c1) * (2 * covariance + c2) /
           ((m->a * m->a + m->b * m->b + c1) * (variance_a + variance_b + c2));
}

/* The Gaussian is separable: columns first, then eleven columns a window. A ring holds the columns
 * that the windows of one row still share. */
static double row_similarity(const Picture *a, const Picture *b, const double *weight, uint32_t y)
{
    Moments ring[SSIM_WINDOW];
    double sum = 0;
    for (uint32_t x = 0; x < a->width; x++) {
        ring[x % SSIM_WINDOW] = column_moments(a, b, weight, x, y);
        if (x + 1 < SSIM_WINDOW)
            continue;
        Moments window = { 0 };
        for (uint32_t i = 0; i < SSIM_WINDOW; i++)
            add_weighted(&window, weight[i], &ring[(x + 1 + i) % SSIM_WINDOW]);
        sum += similarity(&window);
    }
    return sum;
}

static bool is_same_row(const Picture *a, const Picture *b, uint32_t y)
{
    const size_t values = (size_t)a->width * (size_t)a->channels;
    return memcmp(a->values + y * values, b->values + y * values, values * sizeof(float)) == 0;
}

double ssim_of_same(uint32_t width, uint32_t height)
{
    return width < SSIM_WINDOW || height < SSIM_WINDOW ? (double)NAN : 1;
}

double ssim_of(const Picture *a, const Picture *b)
{
    if (isnan(ssim_of_same(a->width, a->height)))
        return (double)NAN;
    double weight[SSIM_WINDOW], sum = 0;
    gaussian(weight);
    uint32_t rows = a->height - SSIM_WINDOW + 1, columns = a->width - SSIM_WINDOW + 1;
    for (uint32_t y = 0, same = 0; y < a->height; y++) {
        same = is_same_row(a, b, y) ? same + 1 : 0;
        if (y + 1 < SSIM_WINDOW)
            continue;
        /* a window against itself is 1 to the bit: both sides of the fraction round alike */
        sum += same >= SSIM_WINDOW ? columns : row_similarity(a, b, weight, y + 1 - SSIM_WINDOW);
    }
    return sum / ((double)rows * columns);
}
