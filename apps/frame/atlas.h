/* Flat textures of patches, and volumes that lie in them as shaders_c/volume/atlas.h has it. */
#ifndef APPS_FRAME_ATLAS_H
#define APPS_FRAME_ATLAS_H

#include "pipeline/resources/surface.h"
#include "shaders_c/volume/atlas.h"

/* Patches in a row, as many as a texture has room for; 0: they do not fit. */
uint32_t atlas_columns(uint32_t width, uint32_t height, uint32_t patches);

VolumePatches atlas_patches(const GpSurface *surface, uint32_t columns, uint32_t width,
                            uint32_t height);

/* A texel of a patch, of `size` texels. */
uint8_t *atlas_texel(const GpSurface *surface, uint32_t columns, const uint32_t size[2], uint32_t x,
                     uint32_t y, uint32_t patch);

/* A zeroed one is empty. Owned by whoever made it, until volume_atlas_free. */
typedef struct VolumeAtlas {
    GpSurface *surface;
    void *texels;
    uint32_t columns;
} VolumeAtlas;

/* in     value: [size[2]][size[1]][size[0]]
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: more samples than a flat texture has room for, some
 *        200 million */
GpResult volume_atlas_make(const uint8_t *value, const uint32_t size[3], VolumeAtlas *atlas,
                           GpError *error);
void volume_atlas_free(VolumeAtlas *atlas);
VolumePatches volume_atlas_patches(const VolumeAtlas *atlas, const uint32_t size[3]);

#endif
