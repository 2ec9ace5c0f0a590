/* What a warped picture should be, and how far off it is. */
#ifndef APPS_TECHNIQUES_WARP_TRUTHS_H
#define APPS_TECHNIQUES_WARP_TRUTHS_H

#include "apps/depth_images/drawing/polygons.h"
#include "apps/truth/ray_picture.h"

typedef struct WarpError {
    double interior_psnr; /* dB, over pixels that both cover; NaN: there are none */
    double missing;       /* pixels that the truth covers and the picture does not */
    double extra;         /* the other way */
    double depth_error;   /* median of how far depth along the view is off where both cover */
    double depth_mean;    /* its mean */
    double rmse;          /* of colours over all pixels, on black, of 1 */
    double covered, both; /* pixels: by the truth; by both */
} WarpError;

/* The mesh itself, at each pixel's centre.
 * errors GP_ERROR_MEMORY; owns: the caller, until ray_picture_free */
GpResult warp_truth_of_mesh(const Polygons *mesh, const WarpView *view, int threads,
                            RayPicture *truth, GpError *error);

/* A depth image that was taken from the eye of the view: of each pixel the one of the image that
 * the ray through its centre falls into.
 * errors GP_ERROR_INVALID: it is none of such an eye, with the reason; GP_ERROR_MEMORY */
GpResult warp_truth_of_image(const DepthImage *image, const WarpView *view, RayPicture *truth,
                             GpError *error);

/* in     color: A8R8G8B8, alpha 0 where nothing was drawn; depth: D32F; of the truth's size
 * errors GP_ERROR_MEMORY */
GpResult warp_error(const RayPicture *truth, const Camera *camera, const GpSurface *color,
                    const GpSurface *depth, WarpError *off);

/* How much brighter than the truth each pixel is, on black, as the mean of its channels.
 * out off: [height][width] */
void warp_difference(const RayPicture *truth, const GpSurface *color, float *off);

#endif
