#include "apps/frame/atlas.h"

uint32_t atlas_columns(uint32_t width, uint32_t height, uint32_t patches)
{
    uint32_t columns = 1;
    while (columns < patches && (columns + 1) * width <= GP_MAX_SIZE)
        columns++;
    return (patches + columns - 1) / columns * height <= GP_MAX_SIZE && width <= GP_MAX_SIZE
               ? columns
               : 0;
}

VolumePatches atlas_patches(const GpSurface *surface, uint32_t columns, uint32_t width,
                            uint32_t height)
{
    return (VolumePatches){
        .columns = (float)columns,
        .patch = { (float)width / (float)surface->width, (float)height / (float)surface->height },
        .texel = { 1 / (float)surface->width, 1 / (float)surface->height },
    };
}

uint8_t *atlas_texel(const GpSurface *surface, uint32_t columns, const uint32_t size[2], uint32_t x,
                     uint32_t y, uint32_t patch)
{
    return gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                            patch % columns * size[0] + x, patch / columns * size[1] + y);
}

static uint32_t slabs_of(const uint32_t size[3])
{
    return (size[2] - 1) / VOLUME_SLAB + 1;
}

/* The slices of a slab, side by side; past the last slice it goes on. */
static void fill_slab(const uint8_t *value, const uint32_t size[3], uint32_t slab,
                      const VolumeAtlas *atlas)
{
    const uint32_t nx = size[0], ny = size[1], nz = size[2];
    for (uint32_t y = 0; y < ny; y++) {
        uint8_t *to = atlas_texel(atlas->surface, atlas->columns, size, 0, y, slab);
        const uint8_t *from[VOLUME_SLAB + 1];
        for (uint32_t k = 0; k <= VOLUME_SLAB; k++) {
            const uint32_t z = slab * VOLUME_SLAB + k;
            from[k] = value + ((size_t)(z < nz ? z : nz - 1) * ny + y) * nx;
        }
        for (uint32_t x = 0; x < nx; x++, to += VOLUME_SLAB + 1)
            for (uint32_t k = 0; k <= VOLUME_SLAB; k++)
                to[k] = from[k][x];
    }
}

/* Rows are an odd number of cache lines, so that those above each other do not share their sets. */
GpResult volume_atlas_make(const uint8_t *value, const uint32_t size[3], VolumeAtlas *atlas,
                           GpError *error)
{
    const uint32_t slabs = slabs_of(size), columns = atlas_columns(size[0], size[1], slabs);
    if (columns == 0)
        return gp_fail(
            error, GP_ERROR_UNSUPPORTED,
            "a volume of %u x %u x %u samples: expected what %u x %u texels have room for", size[0],
            size[1], size[2], GP_MAX_SIZE, GP_MAX_SIZE);
    const uint32_t width = columns * size[0], height = (slabs + columns - 1) / columns * size[1];
    const size_t line = 64, pitch = (((size_t)width * 4 + line - 1) / line | 1) * line;
    VolumeAtlas made = { .texels = gp_alloc(height, pitch), .columns = columns };
    if (!made.texels)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8,
                                 .width = width,
                                 .height = height,
                                 .name = "volume",
                                 .memory = made.texels,
                                 .pitch = pitch };
    const GpResult result = gp_surface_create(&desc, &made.surface, error);
    if (result) {
        gp_free(made.texels);
        return result;
    }
    for (uint32_t slab = 0; slab < slabs; slab++)
        fill_slab(value, size, slab, &made);
    *atlas = made;
    return GP_OK;
}

void volume_atlas_free(VolumeAtlas *atlas)
{
    gp_surface_destroy(&atlas->surface);
    gp_free(atlas->texels);
    *atlas = (VolumeAtlas){ .surface = NULL };
}

VolumePatches volume_atlas_patches(const VolumeAtlas *atlas, const uint32_t size[3])
{
    return atlas_patches(atlas->surface, atlas->columns, size[0], size[1]);
}
