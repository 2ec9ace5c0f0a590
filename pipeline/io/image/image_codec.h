/* What the parts of the picture reader and writer say to each other (internal). */
#ifndef GP_IO_IMAGE_CODEC_H
#define GP_IO_IMAGE_CODEC_H

#include "pipeline/io/file.h"
#include "pipeline/io/image/image.h"

typedef enum GpImageFormat {
    GP_IMAGE_PNG,
    GP_IMAGE_EXR,
    GP_IMAGE_PFM,
    GP_IMAGE_PPM,
    GP_IMAGE_PGM,
    GP_IMAGE_TGA,
} GpImageFormat;

/* A picture file in memory, and what its header says. */
typedef struct GpImageSource {
    const char *path; /* for messages */
    GpImageFormat format;
    GpFile file;
    uint32_t width, height;

    /* PPM, PGM, PFM only */
    uint32_t channels;
    GpImageType type;
    size_t body; /* first byte of the samples */
    bool is_big_endian;
} GpImageSource;

/* Checks magic, header and size before anything is decoded or allocated.
 * in/out source: format, path and file are set; the header's fields are filled in
 * errors GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED */
GpResult gp_image_check(GpImageSource *source, GpError *error);

/* Checks a size for all formats: both sides in 1..GP_IMAGE_SIDE_MAX and at most 4 GiB for 16 bytes
 * a pixel or what else is given. */
GpResult gp_image_check_size(const char *path, uint64_t width, uint64_t height, uint64_t pixel_size,
                             GpError *error);

/* PPM, PGM and PFM in C; the others by OpenImageIO, after which the floating-point environment is as
 * before. Decoding needs a checked source; encoding gives bytes for gp_file_free.
 * errors GP_ERROR_FORMAT (OpenImageIO), GP_ERROR_UNSUPPORTED (OpenImageIO), GP_ERROR_MEMORY */
GpResult gp_image_decode_pnm(const GpImageSource *source, GpImage *image, GpError *error);
GpResult gp_image_encode_pnm(const char *path, GpImageFormat format, const GpImage *image,
                             GpFile *file, GpError *error);
GpResult gp_image_decode_oiio(const GpImageSource *source, GpImage *image, GpError *error);
GpResult gp_image_encode_oiio(const char *path, GpImageFormat format, const GpImage *image,
                              GpFile *file, GpError *error);

#endif
