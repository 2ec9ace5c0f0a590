/* What of a comparison can be seen: pictures made of two. */
#ifndef APPS_COMPARE_COMPARISON_VIEWS_H
#define APPS_COMPARE_COMPARISON_VIEWS_H

#include "apps/compare/comparison.h"

/* Absolute differences of red, green and blue, or of grey, each with that of alpha added as grey,
 * such that the largest is 1 (infinite ones too).
 * out    view: three channels; scale: what differences were multiplied by, 0 where none is finite
 * errors GP_ERROR_MEMORY; owns: the caller, until picture_free */
GpResult view_difference(const Picture pictures[2], double largest, Picture *view, double *scale,
                         GpError *error);

/* FLIP's map in colours, from black (0) by violet and orange to pale yellow (1). As above. */
GpResult view_flip(const Comparison *comparison, Picture *view, GpError *error);

/* The part of a picture at (x, y), so many pixels a side or as many as there are. As above. */
GpResult view_part(const Picture *picture, uint32_t x, uint32_t y, uint32_t side, Picture *view,
                   GpError *error);

#endif
