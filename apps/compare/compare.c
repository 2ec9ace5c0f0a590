#include "apps/compare/compare.h"

#include "apps/base/stable_math.h"
#include "apps/compare/ssim.h"

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
    const int channels = a->channels;
    const size_t values = (x1 - x0) * (size_t)channels;
    if (memcmp(pixel_of(a, x0, y), pixel_of(b, x0, y), values * sizeof(float)) == 0)
        return;
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
        sums->failing += largest > fmax(limits->fail, 0);
        sums->warning += limits->warn >= 0 && largest > limits->warn;
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
    const double ln_10 = 2.302585092994046;
    report->psnr = report->rmse > 0 ? -20 * (stable_log(report->rmse) / ln_10) : HUGE_VAL;
    report->ssim = ssim_of(a, b);
    report->same = sums.differing == 0;
    if (!report->same)
        find_first(a, b, report);

    /* With fail 0 a difference of bits alone (0 against -0) fails too. */
    uint64_t failing = limits->fail > 0 ? sums.failing : sums.differing;
    report->failed = (double)failing > fmax(limits->fail_percent, 0) / 100 * pixels ||
                     (limits->hard_fail >= 0 && sums.max > limits->hard_fail);
    report->warned = (double)sums.warning > fmax(limits->warn_percent, 0) / 100 * pixels ||
                     (limits->hard_warn >= 0 && sums.max > limits->hard_warn);
}

CompareReport compare_same(uint32_t width, uint32_t height)
{
    return (CompareReport){ .pixels = (uint64_t)width * height,
                            .psnr = HUGE_VAL,
                            .ssim = ssim_of_same(width, height),
                            .same = true };
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
