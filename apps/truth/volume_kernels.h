/* A picture of a volume as splats describe it, as exact as it can be said: every sample is
 * classified and has a Gaussian kernel, kernels add up to densities of extinction and of light sent
 * out, and these are integrated along rays, in double. Then the picture is filtered by the pixel's
 * Gaussian. Splats that are classified before they are splatted are held against it.
 *
 * A sample of opacity a adds extinction -ln(1 - a) k(r) and as much light in its colour; k is
 * exp(-r^2 / (2 deviation^2)) of the distance r in samples along the volume's own axes, 0 from r =
 * cut on, times what makes its integral 1.
 */
#ifndef APPS_TRUTH_VOLUME_KERNELS_H
#define APPS_TRUTH_VOLUME_KERNELS_H

#include "apps/truth/volume_picture.h"

typedef struct VolumeKernels {
    double deviation; /* samples */
    double cut;       /* samples */
    /* standard deviation of the pixel's filter, pixels; 0: rays through the centres of pixels are
     * not filtered */
    double low_pass;
    /* a side of a pixel, where there is a filter: 2 are enough where kernels and the filter are no
     * narrower than 0.4 pixels */
    uint32_t rays;
    uint32_t fineness; /* steps along a ray are 0.4 samples, and shorter by so much; 0 is 1 */
} VolumeKernels;

/* order  the same bits for any number of threads
 * errors GP_ERROR_MEMORY; owns: the caller, until volume_picture_free */
GpResult volume_kernels_picture(const VolumeScene *scene, const VolumeKernels *kernels,
                                GpPool *pool, VolumePicture *picture);

/* The height of a kernel, which makes its integral 1. */
double volume_kernel_height(double deviation, double cut);

#endif
