#include "apps/frame/compare.h"

#include <math.h>
#include <string.h>

/* Absolute difference of two values; infinite where only their bits could say what it is. */
static double difference(float a, float b)
{
    if (gp_float_bits(a) == gp_float_bits(b))
        return 0;
    double distance = fabs((double)a - (double)b);
    return isnan(distance) ? HUGE_VAL : distance;
}

static const float *pixel_of(const Picture *picture, uint32_t x, uint32_t y)
{
    size_t index = (size_t)y * picture->width + x;
    return picture->values + index * (size_t)picture->channels;
}

/* --- SSIM ------------------------------------------------------------------------------------- */

/* Gaussian of sigma 1.5 at -5..5, normalised to sum 1. */
static void gaussian(double weight[COMPARE_WINDOW])
{
    double sum = 0;
    for (int i = 0; i < COMPARE_WINDOW; i++) {
        double d = i - COMPARE_WINDOW / 2;
        weight[i] = exp(-d * d / (2 * 1.5 * 1.5));
        sum += weight[i];
    }
    for (int i = 0; i < COMPARE_WINDOW; i++)
        weight[i] /= sum;
}

static double luminance(const Picture *picture, uint32_t x, uint32_t y)
{
    const float *v = pixel_of(picture, x, y);
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
    for (uint32_t i = 0; i < COMPARE_WINDOW; i++) {
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
    Moments ring[COMPARE_WINDOW];
    double sum = 0;
    for (uint32_t x = 0; x < a->width; x++) {
        ring[x % COMPARE_WINDOW] = column_moments(a, b, weight, x, y);
        if (x + 1 < COMPARE_WINDOW)
            continue;
        Moments window = { 0 };
        for (uint32_t i = 0; i < COMPARE_WINDOW; i++)
            add_weighted(&window, weight[i], &ring[(x + 1 + i) % COMPARE_WINDOW]);
        sum += similarity(&window);
    }
    return sum;
}

static double ssim_of(const Picture *a, const Picture *b)
{
    if (a->width < COMPARE_WINDOW || a->height < COMPARE_WINDOW)
        return (double)NAN;
    double weight[COMPARE_WINDOW], sum = 0;
    gaussian(weight);
    uint32_t rows = a->height - COMPARE_WINDOW + 1, columns = a->width - COMPARE_WINDOW + 1;
    for (uint32_t y = 0; y < rows; y++)
        sum += row_similarity(a, b, weight, y);
    return sum / ((double)rows * columns);
}

/* --- sums ------------------------------------------------------------------------------------- */

/* Sums over one rectangle. */
typedef struct Sums {
    double absolute, squared, max;
    uint64_t differing, failing, warning;
} Sums;

/* Adds one row of a tile. */
static void add_row(const Picture *a, const Picture *b, const CompareLimits *limits, uint32_t x0,
                    uint32_t x1, uint32_t y, Sums *sums)
{
    int channels = a->channels;
    for (uint32_t x = x0; x < x1; x++) {
        const float *va = pixel_of(a, x, y), *vb = pixel_of(b, x, y);
        if (memcmp(va, vb, (size_t)channels * sizeof *va) == 0)
            continue;
        double largest = 0;
        for (int c = 0; c < channels; c++) {
            double d = difference(va[c], vb[c]);
            sums->absolute += d;
            sums->squared += d * d;
            largest = d > largest ? d : largest;
        }
        sums->max = largest > sums->max ? largest : sums->max;
        sums->differing++;
        sums->failing += largest > limits->fail;
        sums->warning += largest > limits->warn;
    }
}

static void find_first(const Picture *a, const Picture *b, CompareReport *report)
{
    size_t bytes = (size_t)a->channels * sizeof(float);
    for (uint32_t y = 0; y < a->height; y++) {
        for (uint32_t x = 0; x < a->width; x++) {
            if (memcmp(pixel_of(a, x, y), pixel_of(b, x, y), bytes) != 0) {
                report->first_x = x;
                report->first_y = y;
                return;
            }
        }
    }
}

/* Tile by tile: each tile's sums, folded in tile order; and the worst one. */
static Sums sum_tiles(const Picture *a, const Picture *b, const CompareLimits *limits,
                      CompareReport *report)
{
    Sums total = { 0 };
    double worst = 0;
    for (uint32_t y0 = 0; y0 < a->height; y0 += COMPARE_TILE) {
        uint32_t y1 = y0 + COMPARE_TILE < a->height ? y0 + COMPARE_TILE : a->height;
        for (uint32_t x0 = 0; x0 < a->width; x0 += COMPARE_TILE) {
            uint32_t x1 = x0 + COMPARE_TILE < a->width ? x0 + COMPARE_TILE : a->width;
            Sums tile = { 0 };
            for (uint32_t y = y0; y < y1; y++)
                add_row(a, b, limits, x0, x1, y, &tile);
            if (tile.squared > worst) {
                worst = tile.squared;
                report->tile_x = x0;
                report->tile_y = y0;
                report->tile_differing = tile.differing;
            }
            total.absolute += tile.absolute;
            total.squared += tile.squared;
            total.max = tile.max > total.max ? tile.max : total.max;
            total.differing += tile.differing;
            total.failing += tile.failing;
            total.warning += tile.warning;
        }
    }
    return total;
}

void compare_pictures(const Picture *a, const Picture *b, const CompareLimits *limits,
                      CompareReport *report)
{
    GP_ASSERT(a->width == b->width && a->height == b->height && a->channels == b->channels);
    *report = (CompareReport){ .pixels = (uint64_t)a->width * a->height };
    Sums sums = sum_tiles(a, b, limits, report);

    double count = (double)report->pixels * a->channels, pixels = (double)report->pixels;
    report->differing = sums.differing;
    report->failing = sums.failing;
    report->warning = sums.warning;
    report->max = sums.max;
    report->mean = sums.absolute / count;
    report->rmse = sqrt(sums.squared / count);
    report->psnr = report->rmse > 0 ? -20 * log10(report->rmse) : HUGE_VAL;
    report->ssim = ssim_of(a, b);
    report->same = sums.differing == 0;
    if (!report->same)
        find_first(a, b, report);

    /* With fail 0 a difference of bits alone (0 against -0) fails too. */
    uint64_t failing = limits->fail > 0 ? sums.failing : sums.differing;
    report->failed = (double)failing > limits->fail_percent / 100 * pixels ||
                     (limits->hard_fail > 0 && sums.max > limits->hard_fail);
    report->warned =
        (limits->warn > 0 && (double)sums.warning > limits->warn_percent / 100 * pixels) ||
        (limits->hard_warn > 0 && sums.max > limits->hard_warn);
}

/* --- difference picture ----------------------------------------------------------------------- */

void compare_difference(const Picture *a, const Picture *b, double scale, float *values)
{
    size_t pixels = (size_t)a->width * a->height, channels = (size_t)a->channels;
    for (size_t i = 0; i < pixels * channels; i++) {
        bool alpha = i % channels == 3;
        values[i] = alpha ? 1 : (float)(difference(a->values[i], b->values[i]) * scale);
    }
}
