/* Relief texture mapping of planar depth images: a texture is warped by the processor for each
 * frame, and drawn on a rectangle. */
#ifndef APPS_DEPTH_IMAGES_RIVALS_RELIEF_TEXTURE_H
#define APPS_DEPTH_IMAGES_RIVALS_RELIEF_TEXTURE_H

#include "apps/depth_images/rivals/slab.h"

/* All zero: as it is meant. */
typedef struct ReliefTextureSetting {
    double cut;       /* as of prewarp.h; 0: 0.02; below 0: gaps are all filled, as printed */
    const char *name; /* of the pass, borrowed; NULL: "relief_texture" */
} ReliefTextureSetting;

/* A zeroed one is empty, and draws nothing. Owned by whoever made it, until
 * relief_texture_close. */
typedef struct ReliefTexture {
    DepthSlab slab;
    DepthPixels pixels; /* borrowed from the image, which stays */
    DepthTextures textures;
} ReliefTexture;

/* errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: a cylinder, or as large as textures may be at
 *      most */
GpResult relief_texture_open(const DepthImage *image, ReliefTexture *made, GpError *error);
void relief_texture_close(ReliefTexture *made);

/* Warps the texture, which is part of what a frame costs, and appends a pass.
 * errors GP_ERROR_MEMORY */
GpResult relief_texture_add(const ReliefTexture *made, const ReliefTextureSetting *setting,
                            const WarpView *view, const WarpTarget *target, Frame *frame,
                            GpError *error);

#endif
