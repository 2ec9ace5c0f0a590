/* Scanned volumes as flat textures that one filtered read samples between voxels.
 *
 * A volume is cut into slabs of VOLUME_SLAB steps along z. Each is a patch of the texture, as large
 * as the volume's slices; a texel holds the samples of the slab's slices at its place, the last of
 * which is the first of the next slab: blue, green, red, alpha. Patches lie in rows of `columns`,
 * slab 0 at the top left. A read between texels is linear along x and y in all four slices at once;
 * which two of them count is left to the shader.
 * source Dong et al. 2004 call it a worksheet; slices that two patches share: ours */
#ifndef SHADERS_VOLUME_ATLAS_H
#define SHADERS_VOLUME_ATLAS_H

enum { VOLUME_SLAB = 3 };

/* A flat texture of patches: places on it go from 0 to 1. */
typedef struct VolumePatches {
    float columns;
    float patch[2]; /* sides of a patch */
    float texel[2]; /* sides of a texel */
} VolumePatches;

#endif
