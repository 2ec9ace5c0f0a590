/* A picture of a volume's data, as exact as it can be said: samples are interpolated trilinearly,
 * then classified, and light that is sent out and taken along the ray through each pixel's centre
 * is integrated, in double. Ray casting, slices and splats that are classified late are held
 * against it.
 *
 * A ray is walked from cell to cell, and within each by Gauss's rule of two points on steps of at
 * most a quarter of a sample, which end at the transfer function's stops too, and are shorter where
 * much light is taken: at least eight points a sample. Cells that nothing in them can be seen of
 * are left out, which changes nothing.
 */
#ifndef APPS_TRUTH_VOLUME_RAYS_H
#define APPS_TRUTH_VOLUME_RAYS_H

#include "apps/truth/volume_picture.h"

/* in     fineness: steps are shorter by so much; 1: as above
 * order  the same bits for any number of threads
 * errors GP_ERROR_MEMORY; owns: the caller, until volume_picture_free */
GpResult volume_rays_picture(const VolumeScene *scene, uint32_t fineness, GpPool *pool,
                             VolumePicture *picture);

#endif
