/* FLIP: how much an eye that flips between two pictures would notice, pixel by pixel.
 *
 * Colours are blurred as far as an eye at that distance does, and their difference taken; where
 * edges or points come or go it counts for more.
 *
 * source Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference
 *        Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020,
 *        for low dynamic range, with its erratum (the achromatic channel is divided by 116).
 *        Pictures go on as their border beyond it. In double where the authors' programs use
 *        float. */
#ifndef APPS_COMPARE_FLIP_H
#define APPS_COMPARE_FLIP_H

#include "apps/frame/picture.h"
#include "pipeline/base/pool.h"

/* Pixels per degree of the viewer's field: the paper's, a screen 0.7 m and 3840 pixels wide seen
 * from 0.7 m. */
#define FLIP_PIXELS_PER_DEGREE      67.02064327658226
#define FLIP_MOST_PIXELS_PER_DEGREE 500.0

typedef struct FlipReport {
    double mean, max; /* over all pixels, in [0, 1] */
} FlipReport;

/* Compares two pictures of one size. Values are taken for sRGB codes and cut to [0, 1] (NaN: 0);
 * grey stands for all three colours; alpha is not looked at.
 * in     pixels_per_degree: 1..FLIP_MOST_PIXELS_PER_DEGREE; pool: does the work in bands of rows
 * out    map: [height][width], in [0, 1], 0 where both look the same; report
 * order  the same bits for any pool; the mean is summed row by row from the top
 * errors GP_ERROR_MEMORY */
GpResult flip_compare(const Picture *a, const Picture *b, double pixels_per_degree, GpPool *pool,
                      float *map, FlipReport *report, GpError *error);

#endif
