#include "apps/frame/picture.h"

#include "pipeline/io/file.h"
#include "pipeline/io/image/image_file.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* Channel `wanted` of `channels` of a pixel that has `had`: grey is repeated, a missing alpha is
 * 1. */
static float channel_of(const float *pixel, int had, int wanted, int channels)
{
    bool alpha = channels % 2 == 0 && wanted == channels - 1;
    if (!alpha)
        return pixel[had > 2 ? wanted : 0];
    return had % 2 == 0 ? pixel[had - 1] : 1.0f;
}

/* --- reading ---------------------------------------------------------------------------------- */

static float load_sample(const GpImage *image, size_t index)
{
    switch (image->type) {
    case GP_IMAGE_U8:
        return gp_float_from_unorm(((const uint8_t *)image->data)[index], 8);
    case GP_IMAGE_U16:
        return gp_float_from_unorm(((const uint16_t *)image->data)[index], 16);
    case GP_IMAGE_F16:
        return gp_float_from_half(((const uint16_t *)image->data)[index]);
    default:
        return ((const float *)image->data)[index];
    }
}

/* The same for all of them: bytes have few values, and are most of what is read. */
static void load_bytes(const uint8_t *data, size_t count, float *values)
{
    float value[256];
    for (uint32_t code = 0; code < 256; code++)
        value[code] = gp_float_from_unorm(code, 8);
    for (size_t i = 0; i < count; i++)
        values[i] = value[data[i]];
}

GpResult picture_of_image(const GpImage *image, Picture *picture, GpError *error)
{
    size_t count = (size_t)image->width * image->height * image->channels;
    float *values = gp_alloc(count, sizeof *values);
    if (!values)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (image->type == GP_IMAGE_U8)
        load_bytes(image->data, count, values);
    else
        for (size_t i = 0; i < count; i++)
            values[i] = load_sample(image, i);
    *picture = (Picture){ image->width, image->height, (int)image->channels, values };
    return GP_OK;
}

GpResult picture_read(const char *path, Picture *picture, GpError *error)
{
    GpImage image = { .data = NULL };
    GpResult result = gp_image_read(path, &image, error);
    if (result)
        return result;
    if (picture_of_image(&image, picture, error))
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: out of memory", path);
    gp_image_free(&image);
    return result;
}

GpResult picture_set_channels(Picture *picture, int channels, GpError *error)
{
    int had = picture->channels;
    if (channels == had)
        return GP_OK;
    size_t pixels = (size_t)picture->width * picture->height;
    float *values = gp_alloc(pixels, (size_t)channels * sizeof *values);
    if (!values)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (size_t i = 0; i < pixels; i++)
        for (int c = 0; c < channels; c++)
            values[i * (size_t)channels + (size_t)c] =
                channel_of(picture->values + i * (size_t)had, had, c, channels);
    gp_free(picture->values);
    picture->values = values;
    picture->channels = channels;
    return GP_OK;
}

void picture_free(Picture *picture)
{
    gp_free(picture->values);
    *picture = (Picture){ .values = NULL };
}

/* --- writing ---------------------------------------------------------------------------------- */

bool picture_has_extension(const char *path)
{
    static const char *const known[] = { "png", "exr", "pfm", "ppm" };
    for (size_t i = 0; i < GP_COUNT(known); i++)
        if (gp_file_has_extension(path, known[i]))
            return true;
    return false;
}

GpResult picture_check_path(const char *path, GpError *error)
{
    if (!picture_has_extension(path))
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: expected a name that ends in .png, .exr, .pfm or .ppm", path);
    if (gp_path_is_folder(path))
        return gp_fail(error, GP_ERROR_INVALID, "%s: is a directory", path);
    return GP_OK;
}

/* How a file holds a picture: what its format can, and of that what fits the source best. */
static void choose_samples(const char *path, GpImageType source, GpImage *image)
{
    const bool pfm = gp_file_has_extension(path, "pfm"), ppm = gp_file_has_extension(path, "ppm");
    if (pfm || gp_file_has_extension(path, "exr"))
        image->type = source == GP_IMAGE_F16 && !pfm ? GP_IMAGE_F16 : GP_IMAGE_F32;
    else
        image->type = source == GP_IMAGE_U16 ? GP_IMAGE_U16 : GP_IMAGE_U8;
    if (ppm)
        image->channels = 3;
    else if (pfm)
        image->channels = image->channels > 2 ? 3 : 1;
}

static void store_sample(const GpImage *image, size_t index, float value)
{
    switch (image->type) {
    case GP_IMAGE_U8:
        ((uint8_t *)image->data)[index] = (uint8_t)gp_unorm_from_float(value, 8);
        break;
    case GP_IMAGE_U16:
        ((uint16_t *)image->data)[index] = (uint16_t)gp_unorm_from_float(value, 16);
        break;
    case GP_IMAGE_F16:
        ((uint16_t *)image->data)[index] = gp_half_from_float(value);
        break;
    default:
        ((float *)image->data)[index] = value;
    }
}

/* An image of the samples that a file of this name would have, without data.
 * in channels: of the picture. errors GP_ERROR_MEMORY */
static GpResult begin_image(const char *path, uint32_t width, uint32_t height, int channels,
                            GpImageType source, GpImage *image, GpError *error)
{
    *image = (GpImage){ .width = width, .height = height, .channels = (uint32_t)channels };
    choose_samples(path, source, image);
    return gp_image_alloc(image, path, error);
}

/* A row of pixels of `had` channels. */
static void store_row(const GpImage *image, uint32_t y, const float *values, int had)
{
    const int channels = (int)image->channels;
    size_t index = (size_t)y * image->width * image->channels;
    for (uint32_t x = 0; x < image->width; x++)
        for (int c = 0; c < channels; c++)
            store_sample(image, index++, channel_of(values + x * (size_t)had, had, c, channels));
}

static GpResult sample_picture(const char *path, const Picture *picture, GpImageType source,
                               GpImage *image, GpError *error)
{
    const int had = picture->channels;
    GpResult result = begin_image(path, picture->width, picture->height, had, source, image, error);
    for (uint32_t y = 0; y < picture->height && !result; y++)
        store_row(image, y, picture->values + (size_t)y * picture->width * (size_t)had, had);
    return result;
}

static GpResult write_picture(const char *path, const Picture *picture, GpImageType source,
                              GpPool *pool, GpError *error)
{
    GpImage image;
    GpResult result = sample_picture(path, picture, source, &image, error);
    if (!result)
        result = gp_image_write(path, &image, pool, error);
    gp_image_free(&image);
    return result;
}

GpResult picture_encode_png(const Picture *picture, GpFile *file, GpError *error)
{
    GpImage image;
    GpResult result = sample_picture("picture.png", picture, GP_IMAGE_U8, &image, error);
    if (!result)
        result = gp_image_encode("picture.png", &image, NULL, file, error);
    gp_image_free(&image);
    return result;
}

GpResult picture_write(const char *path, const Picture *picture, GpPool *pool, GpError *error)
{
    return write_picture(path, picture, GP_IMAGE_U8, pool, error);
}

/* --- surfaces --------------------------------------------------------------------------------- */

/* The format that loses nothing. */
static GpFormat format_of(GpImageType type)
{
    return type == GP_IMAGE_U8    ? GP_A8R8G8B8
           : type == GP_IMAGE_F16 ? GP_A16B16G16R16F
                                  : GP_A32B32G32R32F;
}

static void fill_surface(const GpImage *image, GpSurface *surface)
{
    const GpFormat format = format_of(image->type); /* sRGB is how bytes are read, not stored */
    const size_t bytes = gp_format_info(format)->bytes;
    const int channels = (int)image->channels;
    for (uint32_t y = 0; y < image->height; y++)
        for (uint32_t x = 0; x < image->width; x++) {
            float pixel[4], rgba[4];
            for (size_t c = 0; c < image->channels; c++)
                pixel[c] = load_sample(image, ((size_t)y * image->width + x) * image->channels + c);
            for (int c = 0; c < 4; c++)
                rgba[c] = channel_of(pixel, channels, c, 4);
            gp_texel_store(format, gp_surface_texel(&surface->level[0], bytes, x, y), rgba, 0);
        }
}

GpResult picture_read_surface(const char *path, bool srgb, bool mips, GpSurface **surface,
                              GpError *error)
{
    GpImage image = { .data = NULL };
    GpResult result = gp_image_read(path, &image, error);
    if (result)
        return result;
    const GpFormat format = format_of(image.type);
    const GpSurfaceDesc desc = { .format =
                                     srgb && format == GP_A8R8G8B8 ? GP_A8R8G8B8_SRGB : format,
                                 .width = image.width,
                                 .height = image.height,
                                 .levels = mips ? GP_MAX_LEVELS : 1,
                                 .name = "picture" };
    result = gp_surface_create(&desc, surface, error);
    if (!result)
        fill_surface(&image, *surface);
    if (!result && mips)
        gp_surface_build_mips(*surface);
    gp_image_free(&image);
    return result;
}

/* What is taken of a surface's colours. */
typedef enum Part { PART_ALL, PART_OPAQUE, PART_ALPHA } Part;

/* Channels of the picture of a part. Two channels become red and green of three, since a picture's
 * two are grey and alpha. */
static int part_channels(const GpSurface *surface, Part part)
{
    const GpFormatInfo *info = gp_format_info(surface->format);
    const bool three = info->channels == 2 || (part == PART_OPAQUE && info->channels == 4);
    return info->is_depth || part == PART_ALPHA ? 1 : three ? 3 : info->channels;
}

/* A row of level 0 inside a rectangle as floats. Codes survive: dividing by the largest and
 * rounding back is exact (R23, R24). */
static void load_row(const GpSurface *surface, Part part, const GpRect *rect, uint32_t y,
                     float *values)
{
    const GpFormatInfo *info = gp_format_info(surface->format);
    const size_t channels = (size_t)part_channels(surface, part);
    const uint32_t width = (uint32_t)(rect->x1 - rect->x0);
    const uint8_t *texel = gp_surface_texel(&surface->level[0], info->bytes, (uint32_t)rect->x0,
                                            (uint32_t)rect->y0 + y);
    for (uint32_t x = 0; x < width; x++, texel += info->bytes) {
        float rgba[4];
        gp_texel_load(surface->format, texel, rgba);
        if (info->channels == 2)
            rgba[2] = 0;
        memcpy(values + x * channels, part == PART_ALPHA ? rgba + 3 : rgba,
               channels * sizeof *values);
    }
}

/* The samples that hold a format's values without loss, or with the least of the integers. */
static GpImageType samples_of(GpFormat format)
{
    const GpFormatInfo *info = gp_format_info(format);
    if (info->is_depth)
        return GP_IMAGE_U16;
    return info->is_float && info->bytes == 2 * info->channels ? GP_IMAGE_F16 : GP_IMAGE_U8;
}

/* A row of bytes as bytes, which is what floats between them come to. */
static void copy_row(const GpSurface *surface, Part part, const GpRect *rect, uint32_t y,
                     const GpImage *image)
{
    const GpFormatInfo *info = gp_format_info(surface->format);
    uint8_t *to = (uint8_t *)image->data + (size_t)y * image->width * image->channels;
    const uint8_t *texel = gp_surface_texel(&surface->level[0], info->bytes, (uint32_t)rect->x0,
                                            (uint32_t)rect->y0 + y);
    for (uint32_t x = 0; x < image->width; x++, texel += info->bytes)
        for (uint32_t c = 0; c < image->channels; c++)
            *to++ = texel[info->first_byte[part == PART_ALPHA ? 3 : c]];
}

/* Row by row, since a whole picture of floats is four times as large as most surfaces. */
static GpResult sample_surface(const char *path, const GpSurface *surface, Part part,
                               const GpRect *rect, GpImage *image, GpError *error)
{
    const int channels = part_channels(surface, part);
    const uint32_t width = (uint32_t)(rect->x1 - rect->x0);
    const uint32_t height = (uint32_t)(rect->y1 - rect->y0);
    float *row = gp_alloc(width, (size_t)channels * sizeof *row);
    if (!row)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: out of memory", path);
    GpResult result =
        begin_image(path, width, height, channels, samples_of(surface->format), image, error);
    const bool bytes = image->type == GP_IMAGE_U8 &&
                       (surface->format == GP_A8R8G8B8 || surface->format == GP_X8R8G8B8);
    for (uint32_t y = 0; y < height && !result; y++) {
        if (bytes) {
            copy_row(surface, part, rect, y, image);
            continue;
        }
        load_row(surface, part, rect, y, row);
        store_row(image, y, row, channels);
    }
    gp_free(row);
    return result;
}

static GpResult write_part(const char *path, const GpSurface *surface, Part part, GpPool *pool,
                           GpError *error)
{
    GpImage image = { .data = NULL };
    GpResult result = sample_surface(path, surface, part, &surface->window, &image, error);
    if (!result)
        result = gp_image_write(path, &image, pool, error);
    gp_image_free(&image);
    return result;
}

GpResult picture_samples(const char *path, const GpSurface *surface, const GpRect *part,
                         GpImage *image, GpError *error)
{
    return sample_surface(path, surface, PART_ALL, part, image, error);
}

GpResult picture_write_surface(const char *path, const GpSurface *surface, bool opaque,
                               GpPool *pool, GpError *error)
{
    return write_part(path, surface, opaque ? PART_OPAQUE : PART_ALL, pool, error);
}

GpResult picture_write_alpha(const char *path, const GpSurface *surface, GpPool *pool,
                             GpError *error)
{
    GP_ASSERT(gp_format_info(surface->format)->channels == 4);
    return write_part(path, surface, PART_ALPHA, pool, error);
}

void picture_hash_line(const GpSurface *surface, char line[PICTURE_HASH_LINE])
{
    snprintf(line, PICTURE_HASH_LINE, "hash %s %ux%u %016" PRIx64,
             gp_format_info(surface->format)->name, surface->width, surface->height,
             gp_surface_hash(surface));
}
