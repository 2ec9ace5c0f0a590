#include "pipeline/io/image/image_file.h"

#include "pipeline/io/image/image_codec.h"

/* What a format can hold, as bits: of GpImageType, of the channel count. */
typedef struct FormatEntry {
    const char *extension;
    GpImageFormat format;
    unsigned types, channels;
    GpResult (*check)(GpImageSource *);
    GpResult (*decode)(const GpImageSource *, GpImage *);
    GpResult (*encode)(const char *, GpImageFormat, const GpImage *, GpPool *, GpFile *, GpError *);
} FormatEntry;

enum {
    INTEGERS = 1 << GP_IMAGE_U8 | 1 << GP_IMAGE_U16,
    FLOATS = 1 << GP_IMAGE_F16 | 1 << GP_IMAGE_F32,
    ANY_CHANNELS = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 4,
};

/* clang-format off */
static const FormatEntry formats[] = {
    { "png", GP_IMAGE_PNG, INTEGERS, ANY_CHANNELS,
      gp_image_check_png, gp_image_decode_png, gp_image_encode_png },
    { "exr", GP_IMAGE_EXR, FLOATS, ANY_CHANNELS,
      gp_image_check_exr, gp_image_decode_oiio, gp_image_encode_oiio },
    { "pfm", GP_IMAGE_PFM, 1 << GP_IMAGE_F32, 1 << 1 | 1 << 3,
      gp_image_check_pfm, gp_image_decode_pnm, gp_image_encode_pnm },
    { "ppm", GP_IMAGE_PPM, INTEGERS, 1 << 3,
      gp_image_check_pnm, gp_image_decode_pnm, gp_image_encode_pnm },
    { "pgm", GP_IMAGE_PGM, INTEGERS, 1 << 1,
      gp_image_check_pnm, gp_image_decode_pnm, gp_image_encode_pnm },
    { "tga", GP_IMAGE_TGA, 0, 0,
      gp_image_check_tga, gp_image_decode_oiio, NULL },
};
/* clang-format on */

static const char *const type_names[GP_IMAGE_TYPES] = {
    [GP_IMAGE_U8] = "8-bit",
    [GP_IMAGE_U16] = "16-bit",
    [GP_IMAGE_F16] = "half float",
    [GP_IMAGE_F32] = "float",
};

static const FormatEntry *find_format(const char *path)
{
    for (size_t i = 0; i < GP_COUNT(formats); i++)
        if (gp_file_has_extension(path, formats[i].extension))
            return &formats[i];
    return NULL;
}

GpResult gp_image_read(const char *path, GpImage *image, GpError *error)
{
    GP_ASSERT(path && image);
    const FormatEntry *entry = find_format(path);
    if (!entry)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: expected a name that ends with .png, .exr, .pfm, .ppm, .pgm or .tga",
                       path);
    GpImageSource source = { .path = path, .error = error, .format = entry->format };
    GpResult result = gp_file_read(path, &source.file, error);
    if (result != GP_OK)
        return result;
    if (source.file.size == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: the file is empty", path);
    else
        result = entry->check(&source);
    if (result == GP_OK)
        result = entry->decode(&source, image);
    gp_file_free(&source.file);
    return result;
}

static GpResult check_writable(const char *path, const FormatEntry *entry, const GpImage *image,
                               GpError *error)
{
    if (image->width == 0 || image->height == 0 || image->width > GP_IMAGE_SIDE_MAX ||
        image->height > GP_IMAGE_SIDE_MAX)
        return gp_fail(error, GP_ERROR_INVALID, "%s: a picture of %ux%u; sides are 1 to %d", path,
                       image->width, image->height, GP_IMAGE_SIDE_MAX);
    if ((unsigned)image->type >= GP_IMAGE_TYPES || image->channels > 4 ||
        !(entry->types >> image->type & 1) || !(entry->channels >> image->channels & 1))
        return gp_fail(error, GP_ERROR_INVALID, "%s: .%s cannot hold %s samples of %u channels",
                       path, entry->extension,
                       (unsigned)image->type < GP_IMAGE_TYPES ? type_names[image->type] : "such",
                       image->channels);
    return GP_OK;
}

GpResult gp_image_encode(const char *path, const GpImage *image, GpPool *pool, GpFile *file,
                         GpError *error)
{
    GP_ASSERT(path && image && image->data);
    const FormatEntry *entry = find_format(path);
    if (!entry || !entry->encode)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: expected a name that ends with .png, .exr, .pfm, .ppm or .pgm", path);
    GpResult result = check_writable(path, entry, image, error);
    return result ? result : entry->encode(path, entry->format, image, pool, file, error);
}

GpResult gp_image_write(const char *path, const GpImage *image, GpPool *pool, GpError *error)
{
    GpFile file = { .data = NULL, .size = 0 };
    GpResult result = gp_image_encode(path, image, pool, &file, error);
    if (result == GP_OK)
        result = gp_file_write(path, file.data, file.size, error);
    gp_file_free(&file);
    return result;
}
