/* Scanned volumes as flat textures. */
#ifndef APPS_TECHNIQUES_VOXEL_PICTURES_SCAN_H
#define APPS_TECHNIQUES_VOXEL_PICTURES_SCAN_H

#include "apps/techniques/voxel/volume/flat_texture.h"

/* Makes a flat texture of 8 bits a voxel of samples, which lie in its centre; around them it is 0.
 * in   samples: [dims[2]][dims[1]][dims[0]]; spacing: voxels from one sample to the next along each
 *      axis, NULL: 1; linear between samples
 *      size: voxels a side, such as flat_texture_check lets pass with 8 bits */
FlatTexture voxel_scan(Frame *frame, const uint8_t *samples, const uint32_t dims[3],
                       const double spacing[3], uint32_t size);

/* Appends the pass that finds the slopes of a scan, once for all pictures of it: a flat texture of
 * one voxel a texel, so that 20 x 20 patches of 400 are all that a surface holds. */
enum { VOXEL_SCAN_MAX_SIZE = 400 };
FlatTexture voxel_scan_slopes(Frame *frame, const FlatTexture *scan);

#endif
