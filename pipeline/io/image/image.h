/* Pictures from and to files: PNG, EXR, PFM, PPM, PGM, TGA (read only).
 *
 * No conversion takes place: samples are those of the file, alpha is not multiplied into colours,
 * no gamma is applied. OpenImageIO decodes and encodes; PFM, which it cannot write, is done here.
 */
#ifndef GP_IO_IMAGE_H
#define GP_IO_IMAGE_H

#include "pipeline/base/base.h"

typedef enum GpImageType {
    GP_IMAGE_U8,
    GP_IMAGE_U16,
    GP_IMAGE_F16, /* bits of a half in a uint16_t */
    GP_IMAGE_F32,
    GP_IMAGE_TYPES
} GpImageType;

#define GP_IMAGE_SIDE_MAX 65536

/* Row 0 is the top one. Sample c of pixel (x, y) is number (y * width + x) * channels + c, without
 * gaps, in the machine's byte order. */
typedef struct GpImage {
    uint32_t width, height; /* 1..GP_IMAGE_SIDE_MAX */
    uint32_t channels;      /* 1 grey, 2 grey alpha, 3 r g b, 4 r g b a */
    GpImageType type;
    void *data;
} GpImage;

/* Bytes of one sample. */
size_t gp_image_sample_size(GpImageType type);

/* Reads a picture. The format is that of the extension (png, exr, pfm, ppm, pgm, tga, any case)
 * and must be confirmed by the file's first bytes; nothing else is tried.
 * out    image: untouched on failure. PNG: U8 or U16, palettes and fewer bits expanded. EXR: F16 or
 *        F32 (the widest channel decides), the data window, r g b a order. PFM: F32, scale 1 or -1.
 *        PPM, PGM: U8 or U16 by a maximum of 255 or 65535. TGA: U8, the picture's origin applied
 * errors GP_ERROR_IO (file access); GP_ERROR_FORMAT (no such picture, truncated, a size of 0 or
 *        one that the file's bytes cannot hold; with the byte where it is known);
 *        GP_ERROR_UNSUPPORTED (extension; a side over GP_IMAGE_SIDE_MAX or over 4 GiB of samples;
 *        more than 4 channels; a variant that is not read); GP_ERROR_MEMORY
 * owns   the caller frees the image with gp_image_free */
GpResult gp_image_read(const char *path, GpImage *image, GpError *error);

/* Writes a picture in the format of the extension, by gp_file_write: never half a file. The bytes
 * depend on the samples alone; no date, program or machine is noted.
 * in     image: png: U8, U16; exr: F16, F32 (zip); pfm: F32 of 1 or 3 channels; ppm, pgm: U8, U16
 *        of 3 and of 1 channels
 * errors GP_ERROR_INVALID (a size of 0 or over GP_IMAGE_SIDE_MAX; samples or channels that the
 *        format cannot hold); GP_ERROR_UNSUPPORTED (extension); GP_ERROR_IO; GP_ERROR_MEMORY */
GpResult gp_image_write(const char *path, const GpImage *image, GpError *error);

/* Frees the samples and empties *image; NULL and empty images are fine. */
void gp_image_free(GpImage *image);

#endif
