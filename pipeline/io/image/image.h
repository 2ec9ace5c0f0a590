/* A picture in memory, as files hold it: samples without conversion. */
#ifndef GP_IO_IMAGE_H
#define GP_IO_IMAGE_H

#include "pipeline/base/base.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/* Makes room for the samples of a picture whose other members are set.
 * errors GP_ERROR_MEMORY with a message that begins with `path`
 * owns   the caller, until gp_image_free */
GpResult gp_image_alloc(GpImage *image, const char *path, GpError *error);

/* Frees the samples and empties *image; NULL and empty images are fine. */
void gp_image_free(GpImage *image);

#ifdef __cplusplus
}
#endif

#endif
