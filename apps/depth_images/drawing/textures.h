/* Colours and normals of depth images as textures. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_TEXTURES_H
#define APPS_DEPTH_IMAGES_DRAWING_TEXTURES_H

#include "apps/depth_images/depth_image.h"
#include "pipeline/resources/state.h"

/* A zeroed one is empty. Owned by whoever made it, until depth_textures_close. */
typedef struct DepthTextures {
    GpSurface *color; /* A8R8G8B8, all levels, opaque */
    GpSurface
        *normal; /* A8R8G8B8, all levels: component n of a unit vector as (n + 1) / 2; NULL: none */
} DepthTextures;

/* Eight bits a channel, as files of pictures have. Pixels that show nothing have the colours and normals
 * of those around them, so that filters take in nothing else.
 * in   normals: [height][width][3], or NULL
 * errors GP_ERROR_MEMORY; GP_ERROR_INVALID: larger than textures may be */
GpResult depth_textures_open(const DepthPixels *pixels, const float *normals,
                             DepthTextures *textures, GpError *error);
void depth_textures_close(DepthTextures *textures);

#endif
