/* What the readers and writers of picture files share (internal). */
#ifndef GP_IO_IMAGE_CODEC_H
#define GP_IO_IMAGE_CODEC_H

#include "pipeline/io/file.h"
#include "pipeline/io/image/image.h"
#include "pipeline/io/image/layers.h"

#ifdef __cplusplus
extern "C" {
#endif

struct GpPool;

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
    const char *path; /* for messages, which go to error */
    GpError *error;
    GpImageFormat format;
    GpFile file;
    uint32_t width, height;

    /* PPM, PGM, PFM only */
    uint32_t channels;
    GpImageType type;
    size_t body; /* first byte of the samples */
    bool is_big_endian;
} GpImageSource;

/* --- for checks ------------------------------------------------------------------------------- */

/* The file's bytes. */
const unsigned char *gp_image_bytes(const GpImageSource *source);

/* "byte 12: expected ..". returns GP_ERROR_FORMAT */
GpResult gp_image_refuse(const GpImageSource *source, size_t at, const char *expected);

/* "byte 12: only ..". returns GP_ERROR_UNSUPPORTED */
GpResult gp_image_unsupported(const GpImageSource *source, size_t at, const char *what);

/* Sets a size: both sides in 1..GP_IMAGE_SIDE_MAX, and at most 4 GiB at so many bytes a pixel.
 * errors GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED */
GpResult gp_image_take_size(GpImageSource *source, uint64_t width, uint64_t height,
                            uint64_t pixel_size);

/* At least this many bytes must follow byte `at`. errors GP_ERROR_FORMAT */
GpResult gp_image_need_bytes(const GpImageSource *source, size_t at, uint64_t least);

/* --- formats ---------------------------------------------------------------------------------- */

/* Check magic, header and size before anything is decoded or allocated: decoders allocate what a
 * header asks for.
 * in/out source: path, error, format and file are set; the header's members are filled in
 * errors GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED */
GpResult gp_image_check_png(GpImageSource *source);
GpResult gp_image_check_exr(GpImageSource *source);
GpResult gp_image_check_exr_parts(GpImageSource *source); /* of any number of parts and channels */
GpResult gp_image_check_pnm(GpImageSource *source);
GpResult gp_image_check_pfm(GpImageSource *source);
GpResult gp_image_check_tga(GpImageSource *source);

/* Decoding needs a checked source; encoding gives bytes for gp_file_free, by the threads of a pool
 * where the format has work for them; NULL: alone. The floating-point environment is afterwards as
 * before.
 * errors GP_ERROR_FORMAT (libraries), GP_ERROR_UNSUPPORTED (OpenImageIO), GP_ERROR_MEMORY */
GpResult gp_image_decode_pnm(const GpImageSource *source, GpImage *image);
GpResult gp_image_encode_pnm(const char *path, GpImageFormat format, const GpImage *image,
                             struct GpPool *pool, GpFile *file, GpError *error);
GpResult gp_image_decode_png(const GpImageSource *source, GpImage *image);
GpResult gp_image_encode_png(const char *path, GpImageFormat format, const GpImage *image,
                             struct GpPool *pool, GpFile *file, GpError *error);
GpResult gp_image_decode_oiio(const GpImageSource *source, GpImage *image);
GpResult gp_image_encode_oiio(const char *path, GpImageFormat format, const GpImage *image,
                              struct GpPool *pool, GpFile *file, GpError *error);

/* The same for parts of named channels; encoding needs checked layers. */
GpResult gp_image_decode_layers(const GpImageSource *source, const char *attribute,
                                GpLayers *layers);
GpResult gp_image_encode_layers(const char *path, const char *attribute, const GpLayers *layers,
                                GpFile *file, GpError *error);

/* What libglasspipe_oiio.so exports under the name "gp_image_oiio". */
typedef struct GpImageLibrary {
    GpResult (*decode)(const GpImageSource *, GpImage *);
    GpResult (*encode)(const char *, GpImageFormat, const GpImage *, GpFile *, GpError *);
    GpResult (*decode_layers)(const GpImageSource *, const char *, GpLayers *);
    GpResult (*encode_layers)(const char *, const char *, const GpLayers *, GpFile *, GpError *);
} GpImageLibrary;

#ifdef __cplusplus
}
#endif

#endif
