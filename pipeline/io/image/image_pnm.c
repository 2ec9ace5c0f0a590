/* PPM, PGM and PFM: a text header, then plain samples. OpenImageIO 2.4 loses the low bits of 16-bit
 * ones and cannot write PFM, so these three are done here.
 * source Netpbm, "ppm" and "pgm"; Paul Debevec, HDRShop documentation, "PFM" */
#include "pipeline/io/image/image_codec.h"

#include <stdio.h>
#include <string.h>

/* Copies samples between the file's byte order and the machine's. in and out do not overlap. */
static void copy_samples(void *out, const void *in, size_t count, size_t size, bool swap)
{
    if (!swap || size == 1) {
        memcpy(out, in, count * size);
        return;
    }
    const unsigned char *from = in;
    unsigned char *to = out;
    for (size_t i = 0; i < count; i++, from += size, to += size) {
        for (size_t byte = 0; byte < size; byte++)
            to[byte] = from[size - 1 - byte];
    }
}

static bool machine_is_big_endian(void)
{
    return __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
}

GpResult gp_image_decode_pnm(const GpImageSource *source, GpImage *image, GpError *error)
{
    size_t size = gp_image_sample_size(source->type);
    size_t row = (size_t)source->width * source->channels;
    char *data = gp_alloc(row * source->height, size);
    if (!data)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %ux%u pixels", source->path,
                       source->width, source->height);
    bool from_bottom = source->format == GP_IMAGE_PFM;
    bool swap = source->is_big_endian != machine_is_big_endian();
    const char *next = source->file.data + source->body;
    for (size_t i = 0; i < source->height; i++, next += row * size) {
        size_t y = from_bottom ? source->height - 1 - i : i;
        copy_samples(data + y * row * size, next, row, size, swap);
    }
    *image = (GpImage){ .width = source->width,
                        .height = source->height,
                        .channels = source->channels,
                        .type = source->type,
                        .data = data };
    return GP_OK;
}

GpResult gp_image_encode_pnm(const char *path, GpImageFormat format, const GpImage *image,
                             GpFile *file, GpError *error)
{
    bool is_float = format == GP_IMAGE_PFM;
    bool is_color = image->channels == 3;
    char header[64];
    int length = snprintf(header, sizeof header, "P%c\n%u %u\n%s\n",
                          is_float ? (is_color ? 'F' : 'f') : (is_color ? '6' : '5'), image->width,
                          image->height,
                          is_float                     ? "-1.0"
                          : image->type == GP_IMAGE_U8 ? "255"
                                                       : "65535");
    size_t sample = gp_image_sample_size(image->type);
    size_t row = (size_t)image->width * image->channels;
    size_t size = (size_t)length + sample * row * image->height;
    char *data = gp_alloc(size, 1);
    if (!data)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %zu bytes", path, size);
    memcpy(data, header, (size_t)length);

    /* PFM is written little-endian, the others are big-endian by definition. */
    bool swap = is_float == machine_is_big_endian();
    char *next = data + length;
    for (size_t i = 0; i < image->height; i++, next += row * sample) {
        size_t y = is_float ? image->height - 1 - i : i;
        copy_samples(next, (const char *)image->data + y * row * sample, row, sample, swap);
    }
    *file = (GpFile){ .data = data, .size = size };
    return GP_OK;
}
