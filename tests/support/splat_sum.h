/* A picture of splats by plain sums in double: every splat at every pixel, without cut-off. What
 * the passes that draw splats are held against; it shares no arithmetic with them.
 *
 * The Gaussian of a splat lies on its plane. On the picture it is made wider by the pixel's filter:
 *   affine   as EWA does it, by the projection's derivative in the splat's middle: a Gaussian again
 *   exact    as it is: rays through all of the filter's places meet the plane, by numeric
 *            integration
 * source Zwicker, Pfister, van Baar and Gross, "Surface splatting", SIGGRAPH 2001, eq. 6 (exact)
 *        and 10 (affine); the Jacobian with tangents as printed there
 */
#ifndef TESTS_SPLAT_SUM_H
#define TESTS_SPLAT_SUM_H

#include "apps/base/camera.h"
#include "pipeline/base/pool.h"

typedef struct TruthSplat {
    double position[3], normal[3]; /* world; unit length */
    double radius;                 /* of the disc that hides what is behind it */
    double deviation;              /* standard deviation on the plane, > 0 */
    double area; /* that it stands for: on a flat surface the weights add up to 1 */
    double color[3];
} TruthSplat;

typedef enum SplatSumKind { SPLAT_SUM_AFFINE, SPLAT_SUM_EXACT } SplatSumKind;

typedef struct SplatSumScene {
    /* those that face away from the eye, or are nearer than the near plane, count for nothing */
    const TruthSplat *splats;
    uint32_t count;
    Camera camera; /* perspective */
    uint32_t width, height;
    /* standard deviation of the pixel's filter, pixels; exact: at least 0.2 of those of splats as
     * they are seen, or the integral is coarse */
    double low_pass;
    /* footprints behind the nearest disc from which on splats are hidden: a footprint is a radius
     * and the pixel filter's at its distance (shaders_c/points/splat.h) */
    double epsilon;
    SplatSumKind kind;
} SplatSumScene;

typedef struct SplatSum {
    uint32_t width, height;
    double *color;  /* [height][width][3]: mean by weight; 0 without any */
    double *weight; /* [height][width] */
} SplatSum;

/* order  splats in theirs; the same bits for any number of threads
 * errors GP_ERROR_MEMORY; owns: the caller, until splat_sum_free */
GpResult splat_sum_make(const SplatSumScene *scene, GpPool *pool, SplatSum *sum);

/* Frees and zeroes; a zeroed one is fine. */
void splat_sum_free(SplatSum *sum);

#endif
