/* What is known of many surfels together: their box, cone, curvature, and the one that stands for
 * them. */
#ifndef APPS_POINTS_SUMMARY_H
#define APPS_POINTS_SUMMARY_H

#include "apps/base/symmetric.h"
#include "apps/points/patches.h"

/* Of those that `order` names. */
typedef struct SurfelSummary {
    Moments moments;
    double area, normal_sum[3]; /* by area */
} SurfelSummary;

SurfelSummary surfels_summary(const Surfel *surfels, const uint32_t *order, uint32_t count,
                              const double origin[3]);

/* The axis of a cone: the mean of the normals. */
void summary_axis(const SurfelSummary *summary, float axis[3]);

/* The cosine and sine of the least cone about an axis that holds the normals; -1 and 0 where it
 * does not end before 90 degrees. */
void surfels_cone(const Surfel *surfels, uint32_t count, const float axis[3], float *cosine,
                  float *sine);

/* Mean radius by area. */
double surfels_mean_width(const Surfel *surfels, uint32_t count);

/* The axes of a box from the eigenvectors, and the curvature. */
void summary_axes(const SurfelSummary *summary, float axes[3][3], float *curvature);

/* Fills centre and half of a box whose axes are known, so that it holds the positions. */
void box_around(const Surfel *surfels, uint32_t count, PatchBox *box);

/* The surfel that stands for many, as patches.h says. */
Surfel surfel_parent(const Surfel *leaves, uint32_t count);

#endif
