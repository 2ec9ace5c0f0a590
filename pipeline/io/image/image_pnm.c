/* PPM, PGM and PFM: a text header, then plain samples. OpenImageIO 2.4 loses the low bits of 16-bit
 * ones and cannot write PFM.
 * source Netpbm, "ppm" and "pgm"; Paul Debevec, HDRShop documentation, "PFM" */
#include "pipeline/io/bytes.h"
#include "pipeline/io/image/image_codec.h"

#include <stdio.h>
#include <string.h>

/* --- headers: numbers as text between white space --------------------------------------------- */

static bool is_space(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Moves *at over white space, and over comments where the format has them; false without any. */
static bool skip_space(const GpImageSource *source, size_t *at, bool has_comments)
{
    size_t begin = *at;
    while (*at < source->file.size) {
        if (has_comments && source->file.data[*at] == '#') {
            while (*at < source->file.size && source->file.data[*at] != '\n')
                ++*at;
        } else if (is_space(source->file.data[*at])) {
            ++*at;
        } else {
            break;
        }
    }
    return *at > begin;
}

static bool take_number(const GpImageSource *source, size_t *at, uint64_t *number)
{
    size_t begin = *at;
    *number = 0;
    for (;
         *at < source->file.size && source->file.data[*at] >= '0' && source->file.data[*at] <= '9';
         ++*at) {
        if (*at - begin > 9)
            return false;
        *number = *number * 10 + (uint64_t)(source->file.data[*at] - '0');
    }
    return *at > begin;
}

GpResult gp_image_check_pnm(GpImageSource *source)
{
    bool is_color = source->format == GP_IMAGE_PPM;
    if (source->file.size < 2 || source->file.data[0] != 'P' ||
        source->file.data[1] != (is_color ? '6' : '5'))
        return gp_image_refuse(source, 0, is_color ? "P6" : "P5");
    source->channels = is_color ? 3 : 1;
    size_t at = 2;
    uint64_t number[3];
    for (int i = 0; i < 3; i++) {
        if (!skip_space(source, &at, true) || !take_number(source, &at, &number[i]))
            return gp_image_refuse(source, at, "width, height and the largest value");
    }
    if (number[2] != 255 && number[2] != 65535)
        return gp_image_unsupported(source, at, "the largest value must be 255 or 65535");
    if (at == source->file.size || !is_space(source->file.data[at]))
        return gp_image_refuse(source, at, "white space after the largest value");
    source->type = number[2] == 255 ? GP_IMAGE_U8 : GP_IMAGE_U16;
    source->is_big_endian = true;
    source->body = at + 1;
    uint64_t pixel_size = source->channels * gp_image_sample_size(source->type);
    GpResult result = gp_image_take_size(source, number[0], number[1], pixel_size);
    return result == GP_OK
               ? gp_image_need_bytes(source, source->body, number[0] * number[1] * pixel_size)
               : result;
}

/* The scale's sign tells the byte order; its size is a unit, which nothing here applies. */
GpResult gp_image_check_pfm(GpImageSource *source)
{
    if (source->file.size < 3 || source->file.data[0] != 'P' ||
        (source->file.data[1] != 'F' && source->file.data[1] != 'f'))
        return gp_image_refuse(source, 0, "PF or Pf");
    source->channels = source->file.data[1] == 'F' ? 3 : 1;
    size_t at = 2;
    uint64_t number[2];
    for (int i = 0; i < 2; i++) {
        if (!skip_space(source, &at, false) || !take_number(source, &at, &number[i]))
            return gp_image_refuse(source, at, "width and height");
    }
    if (!skip_space(source, &at, false) || at == source->file.size)
        return gp_image_refuse(source, at, "a scale of 1 or -1");
    source->is_big_endian = source->file.data[at] != '-';
    at += source->file.data[at] == '-' || source->file.data[at] == '+';
    uint64_t unit;
    size_t before = at;
    bool is_one = take_number(source, &at, &unit) && unit == 1;
    if (is_one && at < source->file.size && source->file.data[at] == '.') {
        at++;
        while (at < source->file.size && source->file.data[at] == '0')
            at++;
    }
    if (!is_one || at == source->file.size || !is_space(source->file.data[at]))
        return gp_image_unsupported(source, before, "the scale must be 1 or -1");
    source->type = GP_IMAGE_F32;
    source->body = at + 1;
    GpResult result = gp_image_take_size(source, number[0], number[1], 4 * source->channels);
    return result == GP_OK ? gp_image_need_bytes(source, source->body,
                                                 number[0] * number[1] * 4 * source->channels)
                           : result;
}

/* --- samples ---------------------------------------------------------------------------------- */

GpResult gp_image_decode_pnm(const GpImageSource *source, GpImage *image)
{
    GpImage loaded = { .width = source->width,
                       .height = source->height,
                       .channels = source->channels,
                       .type = source->type };
    GpResult result = gp_image_alloc(&loaded, source->path, source->error);
    if (result != GP_OK)
        return result;
    size_t size = gp_image_sample_size(source->type);
    size_t row = (size_t)source->width * source->channels;
    bool from_bottom = source->format == GP_IMAGE_PFM;
    const char *next = source->file.data + source->body;
    for (size_t i = 0; i < source->height; i++, next += row * size) {
        size_t y = from_bottom ? source->height - 1 - i : i;
        gp_copy_samples((char *)loaded.data + y * row * size, next, row, size,
                        source->is_big_endian);
    }
    *image = loaded;
    return GP_OK;
}

GpResult gp_image_encode_pnm(const char *path, GpImageFormat format, const GpImage *image,
                             struct GpPool *pool, GpFile *file, GpError *error)
{
    (void)pool;
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
    char *next = data + length;
    for (size_t i = 0; i < image->height; i++, next += row * sample) {
        size_t y = is_float ? image->height - 1 - i : i;
        gp_copy_samples(next, (const char *)image->data + y * row * sample, row, sample, !is_float);
    }
    *file = (GpFile){ .data = data, .size = size };
    return GP_OK;
}
