/* Pictures from files, as scenes hold them. */
#include "apps/scene/loader.h"

#include "pipeline/io/image/image_file.h"

/* The format that loses nothing; grey and missing alpha are filled in. */
static GpFormat surface_format(const GpImage *image, bool srgb)
{
    if (image->type == GP_IMAGE_U8)
        return srgb ? GP_A8R8G8B8_SRGB : GP_A8R8G8B8;
    return image->type == GP_IMAGE_F16 ? GP_A16B16G16R16F : GP_A32B32G32R32F;
}

static float sample(const GpImage *image, size_t at)
{
    switch (image->type) {
    case GP_IMAGE_U8:
        return gp_float_from_unorm(((const uint8_t *)image->data)[at], 8);
    case GP_IMAGE_U16:
        return gp_float_from_unorm(((const uint16_t *)image->data)[at], 16);
    case GP_IMAGE_F16:
        return gp_float_from_half(((const uint16_t *)image->data)[at]);
    default:
        return ((const float *)image->data)[at];
    }
}

/* One pixel as it is stored, so that bytes stay the bytes they are in sRGB too. */
static void copy_pixel(const GpImage *image, size_t pixel, GpSurface *surface, uint8_t *texel)
{
    size_t first = pixel * image->channels;
    bool grey = image->channels < 3, alpha = image->channels % 2 == 0;
    float rgba[4];
    for (size_t c = 0; c < 3; c++)
        rgba[c] = sample(image, first + (grey ? 0 : c));
    rgba[3] = alpha ? sample(image, first + image->channels - 1) : 1;
    GpFormat stored = surface->format == GP_A8R8G8B8_SRGB ? GP_A8R8G8B8 : surface->format;
    gp_texel_store(stored, texel, rgba, 0);
}

GpResult scene_load_image(const char *path, bool srgb, bool mips, GpSurface **surface,
                          GpError *error)
{
    GpImage image = { 0 };
    GpSurface *made = NULL;
    GpResult result = gp_image_read(path, &image, error);
    if (result)
        return result;
    GpSurfaceDesc desc = { .format = surface_format(&image, srgb),
                           .width = image.width,
                           .height = image.height,
                           .levels = mips ? GP_MAX_LEVELS : 1,
                           .name = "picture" };
    result = gp_surface_create(&desc, &made, error);
    for (uint32_t y = 0; y < image.height && !result; y++)
        for (uint32_t x = 0; x < image.width; x++)
            copy_pixel(
                &image, (size_t)y * image.width + x, made,
                gp_surface_texel(&made->level[0], gp_format_info(made->format)->bytes, x, y));
    gp_image_free(&image);
    if (result)
        return result;
    if (mips)
        gp_surface_build_mips(made);
    *surface = made;
    return GP_OK;
}
