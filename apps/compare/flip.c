#include "apps/compare/flip.h"

#include "apps/base/stable_math.h"
#include "apps/compare/flip_color.h"
#include "pipeline/base/lanes/types.h"

#include <math.h>
#include <string.h>

enum {
    MOST_RADIUS = 68, /* ceil(3 * 0.045015816 * FLIP_MOST_PIXELS_PER_DEGREE) */
    BAND = 64,        /* rows that one item of work makes */
};

static const double pi = 3.14159265358979323846;

/* --- kernels ---------------------------------------------------------------------------------- */

/* Weights of the pixels -radius..radius along a row or a column. */
typedef struct Kernel {
    int radius;
    double weight[2 * MOST_RADIUS + 1];
} Kernel;

/* exp(-x^2 / spread), with the sum 1; returns what the sum was. */
static double make_gaussian(int radius, double spread, Kernel *kernel)
{
    double sum = 0;
    kernel->radius = radius;
    for (int i = -radius; i <= radius; i++)
        sum += kernel->weight[i + radius] = stable_exp(-(double)(i * i) / spread);
    for (int i = 0; i <= 2 * radius; i++)
        kernel->weight[i] /= sum;
    return sum;
}

/* Scales the weights so that the positive ones sum to 1 and the negative ones to -1. */
static void balance(Kernel *kernel)
{
    double positive = 0, negative = 0;
    for (int i = 0; i <= 2 * kernel->radius; i++) {
        const double weight = kernel->weight[i];
        positive += weight > 0 ? weight : 0;
        negative -= weight < 0 ? weight : 0;
    }
    for (int i = 0; i <= 2 * kernel->radius; i++)
        kernel->weight[i] /= kernel->weight[i] < 0 ? negative : positive;
}

/* --- filters ---------------------------------------------------------------------------------- */

/* What is filtered out of the opponent colours. All filters are products of one along the rows and
 * one along the columns; that of blue against yellow is a sum of two such. */
typedef enum Response {
    ACHROMATIC,
    RED_GREEN,
    BLUE_YELLOW,
    BLUE_YELLOW_NARROW,
    EDGE_ACROSS,
    EDGE_DOWN,
    POINT_ACROSS,
    POINT_DOWN,
    RESPONSES
} Response;

static const int channel_of[RESPONSES] = { 0, 1, 2, 2, 0, 0, 0, 0 };

typedef struct Filters {
    Kernel across[RESPONSES], down[RESPONSES];
    int radius; /* the largest */
} Filters;

/* The eye's sensitivity to contrast, as filters in space: sums of a sqrt(pi / b) exp(-pi^2 x^2 / b)
 * for a distance of x degrees. source section 4.1.1, table 1 */
static void make_sensitivity(double ppd, Filters *filters)
{
    static const double b[] = { 0.0047, 0.0053, 0.04, 0.025 }, a[] = { 1, 1, 34.1, 13.5 };
    const int radius = (int)ceil(3 * sqrt(0.04 / (2 * pi * pi)) * ppd);
    double share[4];
    for (int i = ACHROMATIC; i <= BLUE_YELLOW_NARROW; i++) {
        const double sum =
            make_gaussian(radius, b[i] * (ppd / pi) * (ppd / pi), &filters->across[i]);
        filters->down[i] = filters->across[i];
        share[i] = a[i] * sqrt(pi / b[i]) * sum * sum;
    }
    const double both = share[BLUE_YELLOW] + share[BLUE_YELLOW_NARROW];
    for (int i = BLUE_YELLOW; i <= BLUE_YELLOW_NARROW; i++)
        for (int k = 0; k <= 2 * radius; k++)
            filters->down[i].weight[k] *= share[i] / both;
    filters->radius = radius;
}

/* First and second derivatives of a Gaussian as wide as the eye's own. source section 4.2 */
static void make_features(double ppd, Filters *filters)
{
    const double sigma = 0.5 * 0.082 * ppd;
    const int radius = (int)ceil(3 * sigma);
    Kernel smooth, edge, point;
    make_gaussian(radius, 2 * sigma * sigma, &smooth);
    edge = point = smooth;
    for (int i = -radius; i <= radius; i++) {
        edge.weight[i + radius] *= -i;
        point.weight[i + radius] *= (double)(i * i) / (sigma * sigma) - 1;
    }
    balance(&edge);
    balance(&point);
    filters->across[EDGE_ACROSS] = filters->down[EDGE_DOWN] = edge;
    filters->across[POINT_ACROSS] = filters->down[POINT_DOWN] = point;
    filters->down[EDGE_ACROSS] = filters->across[EDGE_DOWN] = smooth;
    filters->down[POINT_ACROSS] = filters->across[POINT_DOWN] = smooth;
    filters->radius = radius > filters->radius ? radius : filters->radius;
}

/* --- bands ------------------------------------------------------------------------------------ */

/* The work, shared by all bands. */
typedef struct Work {
    const Picture *pictures[2];
    Filters filters;
    float *map;
    bool *failed; /* of each band */
} Work;

/* What a band needs for one picture; filtered: after both directions, of the row in hand. */
typedef struct Band {
    uint32_t width, row0, rows; /* of the picture's rows that are filtered across */
    double *padded[3];          /* a row of opponent colours, with its border on both sides */
    double *across[RESPONSES];  /* [rows][width] */
    double *filtered[RESPONSES];
} Band;

static StablePair load_pair(const double *at)
{
    StablePair pair;
    memcpy(&pair, at, sizeof pair);
    return pair;
}

static double code_at(const Picture *picture, size_t index, int channel)
{
    const float *pixel = picture->values + index * (size_t)picture->channels;
    const double value = (double)pixel[picture->channels > 2 ? channel : 0];
    return value > 0 ? value < 1 ? value : 1 : 0;
}

static void pad_row(const Picture *picture, uint32_t y, int radius, double *const padded[3])
{
    const uint32_t width = picture->width;
    for (uint32_t x = 0; x < width; x += 2) { /* the border has room for one more */
        const size_t at = (size_t)y * width + x, next = x + 1 < width ? at + 1 : at;
        StablePair srgb[3], opponent[3];
        for (int c = 0; c < 3; c++)
            srgb[c] = (StablePair){ code_at(picture, at, c), code_at(picture, next, c) };
        flip_opponent(srgb, opponent);
        for (int c = 0; c < 3; c++)
            memcpy(padded[c] + radius + x, &opponent[c], sizeof opponent[c]);
    }
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < radius; i++) {
            padded[c][i] = padded[c][radius];
            padded[c][(uint32_t)radius + width + (uint32_t)i] =
                padded[c][(uint32_t)radius + width - 1];
        }
}

enum { AT_ONCE = 8 }; /* pixels: sums that do not wait for each other */

GP_INLINE void sum_pairs(int count, const double *const rows[], const Kernel *kernel, uint32_t x,
                         StablePair *sums)
{
    GP_UNROLL for (int i = 0; i < count; i++)
    {
        sums[i] = (StablePair){ 0, 0 };
    }
    for (int k = 0; k <= 2 * kernel->radius; k++)
        GP_UNROLL for (int i = 0; i < count; i++)
        {
            sums[i] += load_pair(rows[k] + x + 2 * i) * kernel->weight[k];
        }
}

/* Writes the sum of rows by a kernel's weights, in its order. What lies behind a row of an odd
 * width is read, but not used. */
static void sum_rows(const double *const rows[], const Kernel *kernel, uint32_t width, double *sums)
{
    StablePair sum[AT_ONCE / 2];
    uint32_t x = 0;
    for (; x + AT_ONCE <= width; x += AT_ONCE) {
        sum_pairs(AT_ONCE / 2, rows, kernel, x, sum);
        memcpy(sums + x, sum, sizeof sum);
    }
    for (; x < width; x += 2) {
        sum_pairs(1, rows, kernel, x, sum);
        memcpy(sums + x, sum, x + 1 < width ? sizeof sum[0] : sizeof(double));
    }
}

static void filter_across(const Filters *filters, const Picture *picture, Band *band)
{
    const double *shifted[2 * MOST_RADIUS + 1];
    for (uint32_t row = 0; row < band->rows; row++) {
        pad_row(picture, band->row0 + row, filters->radius, band->padded);
        for (int r = 0; r < RESPONSES; r++) {
            const Kernel *kernel = &filters->across[r];
            const double *first = band->padded[channel_of[r]] + (filters->radius - kernel->radius);
            for (int k = 0; k <= 2 * kernel->radius; k++)
                shifted[k] = first + k;
            sum_rows(shifted, kernel, band->width, band->across[r] + (size_t)row * band->width);
        }
    }
}

/* Row y of the picture, after both directions. */
static void filter_down(const Filters *filters, const Picture *picture, uint32_t y, Band *band)
{
    const double *rows[2 * MOST_RADIUS + 1];
    for (int r = 0; r < RESPONSES; r++) {
        const Kernel *kernel = &filters->down[r];
        for (int k = -kernel->radius; k <= kernel->radius; k++) {
            const int64_t row = (int64_t)y + k, last = (int64_t)picture->height - 1;
            const int64_t inside = row < 0 ? 0 : row > last ? last : row;
            rows[k + kernel->radius] =
                band->across[r] + (size_t)(inside - band->row0) * band->width;
        }
        sum_rows(rows, kernel, band->width, band->filtered[r]);
    }
}

/* --- difference ------------------------------------------------------------------------------- */

static StablePair root(StablePair x)
{
    return (StablePair){ sqrt(x[0]), sqrt(x[1]) };
}

static StablePair strength(const Band *band, Response across, Response down, uint32_t x)
{
    const StablePair a = load_pair(band->filtered[across] + x);
    const StablePair b = load_pair(band->filtered[down] + x);
    return root(a * a + b * b) / 116;
}

/* How far the strengths of edges, or of points, are apart. The kernels sum to 0, so that of the
 * achromatic channel's scale, 116 Y - 16, only the factor is left. */
static StablePair feature_difference(const Band bands[2], Response across, Response down,
                                     uint32_t x)
{
    const StablePair apart =
        strength(&bands[0], across, down, x) - strength(&bands[1], across, down, x);
    return (StablePair){ fabs(apart[0]), fabs(apart[1]) };
}

/* Of pixels x and x + 1. */
static StablePair pixel_difference(const Band bands[2], uint32_t x)
{
    StablePair opponent[2][3];
    for (int i = 0; i < 2; i++) {
        double *const *filtered = bands[i].filtered;
        opponent[i][0] = load_pair(filtered[ACHROMATIC] + x);
        opponent[i][1] = load_pair(filtered[RED_GREEN] + x);
        opponent[i][2] =
            load_pair(filtered[BLUE_YELLOW] + x) + load_pair(filtered[BLUE_YELLOW_NARROW] + x);
    }
    const StablePair color = flip_color_difference(opponent[0], opponent[1]);
    const StablePair edges = feature_difference(bands, EDGE_ACROSS, EDGE_DOWN, x);
    const StablePair points = feature_difference(bands, POINT_ACROSS, POINT_DOWN, x);
    const StablePair feature = root(stable_choose(edges > points, edges, points) / sqrt(2));
    return stable_pow_pair(color, 1 - feature);
}

/* Arrays of a band, in one piece, with a 0 behind them. NULL: no memory. */
static double *open_band(const Work *work, uint32_t row0, uint32_t rows, Band *band)
{
    const size_t width = work->pictures[0]->width, radius = (size_t)work->filters.radius;
    const size_t padded = width + 2 * radius;
    const size_t numbers = 3 * padded + RESPONSES * (rows + (size_t)1) * width;
    double *memory = gp_alloc_unset((numbers + 1) * sizeof *memory);
    *band = (Band){ .width = (uint32_t)width, .row0 = row0, .rows = rows };
    if (!memory)
        return NULL;
    memory[numbers] = 0;
    double *at = memory;
    for (int c = 0; c < 3; c++, at += padded)
        band->padded[c] = at;
    for (int r = 0; r < RESPONSES; r++, at += (rows + (size_t)1) * width) {
        band->across[r] = at;
        band->filtered[r] = at + rows * width;
    }
    return memory;
}

static void make_band(void *context, uint32_t item, int worker)
{
    (void)worker;
    Work *work = context;
    const uint32_t height = work->pictures[0]->height, width = work->pictures[0]->width;
    const uint32_t radius = (uint32_t)work->filters.radius, y0 = item * BAND;
    const uint32_t y1 = y0 + BAND < height ? y0 + BAND : height;
    const uint32_t row0 = y0 > radius ? y0 - radius : 0;
    const uint32_t row1 = y1 + radius < height ? y1 + radius : height;
    Band bands[2];
    double *memory[2];
    for (int i = 0; i < 2; i++)
        memory[i] = open_band(work, row0, row1 - row0, &bands[i]);
    work->failed[item] = !memory[0] || !memory[1];
    if (!work->failed[item]) {
        for (int i = 0; i < 2; i++)
            filter_across(&work->filters, work->pictures[i], &bands[i]);
        for (uint32_t y = y0; y < y1; y++) {
            for (int i = 0; i < 2; i++)
                filter_down(&work->filters, work->pictures[i], y, &bands[i]);
            for (uint32_t x = 0; x < width; x += 2) {
                const StablePair difference = pixel_difference(bands, x);
                for (uint32_t i = 0; i < 2 && x + i < width; i++)
                    work->map[(size_t)y * width + x + i] = (float)difference[i];
            }
        }
    }
    gp_free(memory[0]);
    gp_free(memory[1]);
}

static FlipReport sum_map(const float *map, size_t count)
{
    FlipReport report = { 0 };
    for (size_t i = 0; i < count; i++) {
        report.mean += (double)map[i];
        report.max = (double)map[i] > report.max ? (double)map[i] : report.max;
    }
    report.mean /= (double)count;
    return report;
}

GpResult flip_compare(const Picture *a, const Picture *b, double pixels_per_degree, GpPool *pool,
                      float *map, FlipReport *report, GpError *error)
{
    GP_ASSERT(a->width == b->width && a->height == b->height);
    GP_ASSERT(pixels_per_degree >= 1 && pixels_per_degree <= FLIP_MOST_PIXELS_PER_DEGREE);
    const uint32_t bands = (a->height + BAND - 1) / BAND;
    Work work = { .pictures = { a, b }, .map = map, .failed = gp_alloc(bands, sizeof(bool)) };
    bool failed = !work.failed;
    if (!failed) {
        make_sensitivity(pixels_per_degree, &work.filters);
        make_features(pixels_per_degree, &work.filters);
        gp_pool_run(pool, bands, make_band, &work);
        for (uint32_t i = 0; i < bands; i++)
            failed |= work.failed[i];
    }
    gp_free(work.failed);
    if (failed)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    *report = sum_map(map, (size_t)a->width * a->height);
    return GP_OK;
}
