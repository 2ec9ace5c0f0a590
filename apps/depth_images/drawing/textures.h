/* Colours and normals of depth images as textures. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_TEXTURES_H
#define APPS_DEPTH_IMAGES_DRAWING_TEXTURES_H

#include "apps/depth_images/depth_image.h"
#include "pipeline/resources/state.h"

/* Eight bits a channel, A8R8G8B8, opaque, as files of pictures have. Pixels that show nothing have
 * the colours and normals of those around them, so that filters take in nothing else. Component n
 * of a normal is (n + 1) / 2.
 * in   levels: GP_MAX_LEVELS: all; normals: [height][width][3]
 * errors GP_ERROR_MEMORY; GP_ERROR_INVALID: larger than textures may be
 * owns   the caller, until gp_surface_destroy */
GpResult depth_color_texture(const DepthPixels *pixels, uint32_t levels, GpSurface **surface,
                             GpError *error);
GpResult depth_normal_texture(const DepthPixels *pixels, const float *normals, uint32_t levels,
                              GpSurface **surface, GpError *error);

/* Both. A zeroed one is empty. Owned by whoever made it, until depth_textures_close. */
typedef struct DepthTextures {
    GpSurface *color;
    GpSurface *normal; /* NULL: none */
} DepthTextures;

/* Of all levels. in: normals: [height][width][3], or NULL; errors as above */
GpResult depth_textures_open(const DepthPixels *pixels, const float *normals,
                             DepthTextures *textures, GpError *error);
void depth_textures_close(DepthTextures *textures);

#endif
