/* The truths of a volume's picture, and how far off it is. */
#ifndef APPS_TECHNIQUES_VOLUME_TRUTHS_H
#define APPS_TECHNIQUES_VOLUME_TRUTHS_H

#include "apps/truth/volume_picture.h"
#include "apps/volumes/drawing/view.h"

/* Of what a splat is. */
typedef struct VolumeKernel {
    double deviation, cut; /* in samples */
    double low_pass;       /* in pixels */
} VolumeKernel;

/* What the data are: interpolated, then classified (apps/truth/volume_rays.h).
 * errors GP_ERROR_MEMORY; owns: the caller, until volume_picture_free */
GpResult volume_truth_of_data(const VolumeSource *source, const VolumeView *view, int threads,
                              VolumePicture *truth, GpError *error);

/* What splats of classified samples stand for (apps/truth/volume_kernels.h). */
GpResult volume_truth_of_kernels(const VolumeSource *source, const VolumeView *view,
                                 const VolumeKernel *kernel, int threads, VolumePicture *truth,
                                 GpError *error);

/* The root of the mean square of how far red, green and blue, multiplied by alpha, are off over all
 * pixels, of 1: on a black background.
 * in   picture: A8R8G8B8, of the truth's size */
double volume_rmse(const VolumePicture *truth, const GpSurface *picture);

/* The same as peak signal to noise ratio, in dB; 200 where nothing is off. */
double volume_psnr(double rmse);

/* How much brighter than the truth each pixel is, as the mean of its channels. out off:
 * [height][width] */
void volume_difference(const VolumePicture *truth, const GpSurface *picture, float *off);

#endif
