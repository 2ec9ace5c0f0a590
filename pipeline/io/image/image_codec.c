#include "pipeline/io/image/image_codec.h"

const unsigned char *gp_image_bytes(const GpImageSource *source)
{
    return (const unsigned char *)source->file.data;
}

GpResult gp_image_refuse(const GpImageSource *source, size_t at, const char *expected)
{
    return gp_fail(source->error, GP_ERROR_FORMAT, "%s: byte %zu: expected %s", source->path, at,
                   expected);
}

GpResult gp_image_unsupported(const GpImageSource *source, size_t at, const char *what)
{
    return gp_fail(source->error, GP_ERROR_UNSUPPORTED, "%s: byte %zu: %s", source->path, at, what);
}

GpResult gp_image_take_size(GpImageSource *source, uint64_t width, uint64_t height,
                            uint64_t pixel_size)
{
    if (width == 0 || height == 0)
        return gp_fail(source->error, GP_ERROR_FORMAT, "%s: a picture of %llux%llu pixels",
                       source->path, (unsigned long long)width, (unsigned long long)height);
    if (width > GP_IMAGE_SIDE_MAX || height > GP_IMAGE_SIDE_MAX ||
        width * height * pixel_size > (uint64_t)1 << 32)
        return gp_fail(source->error, GP_ERROR_UNSUPPORTED,
                       "%s: a picture of %llux%llu pixels is over %d a side or 4 GiB", source->path,
                       (unsigned long long)width, (unsigned long long)height, GP_IMAGE_SIDE_MAX);
    source->width = (uint32_t)width;
    source->height = (uint32_t)height;
    return GP_OK;
}

GpResult gp_image_need_bytes(const GpImageSource *source, size_t at, uint64_t least)
{
    size_t size = source->file.size;
    if (at <= size && least <= size - at)
        return GP_OK;
    return gp_fail(source->error, GP_ERROR_FORMAT,
                   "%s: byte %zu: %ux%u pixels need %llu more bytes, but the file has %zu",
                   source->path, at, source->width, source->height, (unsigned long long)least,
                   size > at ? size - at : 0);
}
