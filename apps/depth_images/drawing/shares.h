/* Which image of a model shows what: each place of it is drawn of the image that has most pixels
 * there, where several see it, and of that one alone. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_SHARES_H
#define APPS_DEPTH_IMAGES_DRAWING_SHARES_H

#include "apps/depth_images/depth_image.h"

/* The share of one image. An image without normals, and perspective ones, keep all that they show.
 * out    own: [height][width] of the image: 1: its to draw; 0: another's, or nothing. The caller's,
 *        until gp_free
 * errors GP_ERROR_MEMORY
 * source ours */
GpResult shares_find(const DepthModel *model, uint32_t image, uint8_t **own);

/* Sums over it, for points of every `step`th column and row: of how many points, above and to the
 * left of a place, there is something of the image's own within a step.
 * out    sums: [rows + 1][columns + 1]; the caller's, until gp_free
 * errors GP_ERROR_MEMORY */
GpResult shares_sum(const DepthImage *image, const uint8_t *own, uint32_t step, uint32_t columns,
                    uint32_t rows, uint32_t **sums);

#endif
