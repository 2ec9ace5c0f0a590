/* Comparison of two pictures: bits, differences, and where they are. */
#ifndef APPS_COMPARE_COMPARE_H
#define APPS_COMPARE_COMPARE_H

#include "apps/frame/picture.h"

enum { COMPARE_TILE = 64 }; /* pixels a side of the tiles that are ranked */

/* Limits under the names of OpenImageIO's idiff; a pixel's difference is the largest of its
 * channels'. Negative ones are not there; without any, any difference fails. */
typedef struct CompareLimits {
    /* fails if more than this share of pixels differs by more than fail; without: 0 */
    double fail, fail_percent;
    double hard_fail;                     /* fails if any pixel differs by more than this */
    double warn, warn_percent, hard_warn; /* the same for a warning; without warn: none */
} CompareLimits;

typedef struct CompareReport {
    uint64_t pixels;
    uint64_t differing; /* with a channel of other bits (0 and -0 differ, equal NaNs do not) */
    uint64_t failing;   /* pixels that differ by more than limits.fail */
    uint64_t warning;   /* by more than limits.warn */
    double max;         /* largest difference of a channel */
    double mean;        /* mean absolute difference, over pixels and channels */
    double rmse;        /* root of the mean squared difference */
    double psnr;        /* decibels, 20 log10(1 / rmse): a peak of 1; infinite where rmse is 0 */
    double ssim;        /* ssim_of */
    uint32_t first_x, first_y; /* first differing pixel, row by row from the top */
    uint32_t tile_x, tile_y;   /* top left pixel of the tile with the largest sum */
    uint64_t tile_differing;   /* of squared differences, and its differing pixels */
    bool same;                 /* no pixel differs */
    bool failed, warned;
} CompareReport;

/* Compares two pictures of one size and number of channels.
 * note  a NaN or infinity against another value counts as an infinite difference
 * order sums run row by row inside a tile, and over the tiles, in double: the same figures
 *       everywhere
 * source definitions in the struct above: ours, limits as in idiff's manual */
void compare_pictures(const Picture *a, const Picture *b, const CompareLimits *limits,
                      CompareReport *report);

/* The same of two pictures of this size that are the same. */
CompareReport compare_same(uint32_t width, uint32_t height);

/* Difference picture: abs(a - b) * scale for each channel, alpha (channel 3) 1.
 * out  values: [height][width][channels] */
void compare_difference(const Picture *a, const Picture *b, double scale, float *values);

#endif
