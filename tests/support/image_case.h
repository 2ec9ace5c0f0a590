/* Pictures read in tests: in the test's own folder, with the last error. */
#ifndef TESTS_IMAGE_CASE_H
#define TESTS_IMAGE_CASE_H

#include "pipeline/io/image/image_file.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

static GpError error;

/* 1x2 r g b a with alpha 1 and 0: premultiplied, the colours would be gone. Deflate stored. */
/* clang-format off */
static const unsigned char tiny_png[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x08, 0x06, 0x00, 0x00, 0x00, 0x99, 0x81, 0xb6,
    0x27, 0x00, 0x00, 0x00, 0x15, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0x01, 0x0a, 0x00, 0xf5, 0xff,
    0x00, 0xc8, 0x64, 0x32, 0x01, 0x00, 0x07, 0x08, 0x09, 0x00, 0x0b, 0xdc, 0x01, 0x78, 0x84, 0xb1,
    0xa0, 0xfd, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
};
/* clang-format on */

static inline size_t image_bytes(const GpImage *image)
{
    return (size_t)image->width * image->height * image->channels *
           gp_image_sample_size(image->type);
}

/* A picture of random bits; floats are kept from being signalling NaNs only. */
static inline GpImage random_image(uint32_t width, uint32_t height, uint32_t channels,
                                   GpImageType type, uint64_t number)
{
    Random seed = { number };
    GpImage image = { .width = width, .height = height, .channels = channels, .type = type };
    image.data = gp_alloc(image_bytes(&image), 1);
    assert_non_null(image.data);
    for (size_t i = 0; i < image_bytes(&image); i++)
        ((uint8_t *)image.data)[i] = (uint8_t)random_word(&seed);
    size_t samples = image_bytes(&image) / gp_image_sample_size(type);
    for (size_t i = 0; i < samples; i++) {
        if (type == GP_IMAGE_F32 && (((uint32_t *)image.data)[i] & 0x7f800000u) == 0x7f800000u)
            ((uint32_t *)image.data)[i] |= 0x00400000u;
        if (type == GP_IMAGE_F16 && (((uint16_t *)image.data)[i] & 0x7c00u) == 0x7c00u)
            ((uint16_t *)image.data)[i] |= 0x0200u;
    }
    return image;
}

static inline void assert_reads(const char *path, GpImage *image)
{
    GpResult result = gp_image_read(path, image, &error);
    if (result != GP_OK)
        fail_msg("%s", error.text);
}

static const struct {
    const char *name;
    GpImageType type;
    uint32_t channels;
} writable[] = {
    { "a.png", GP_IMAGE_U8, 1 },  { "a.png", GP_IMAGE_U8, 2 },  { "a.png", GP_IMAGE_U8, 3 },
    { "a.png", GP_IMAGE_U8, 4 },  { "a.png", GP_IMAGE_U16, 1 }, { "a.png", GP_IMAGE_U16, 2 },
    { "a.png", GP_IMAGE_U16, 3 }, { "a.png", GP_IMAGE_U16, 4 }, { "a.exr", GP_IMAGE_F16, 1 },
    { "a.exr", GP_IMAGE_F16, 3 }, { "a.exr", GP_IMAGE_F16, 4 }, { "a.exr", GP_IMAGE_F32, 1 },
    { "a.exr", GP_IMAGE_F32, 2 }, { "a.exr", GP_IMAGE_F32, 3 }, { "a.exr", GP_IMAGE_F32, 4 },
    { "a.pfm", GP_IMAGE_F32, 1 }, { "a.pfm", GP_IMAGE_F32, 3 }, { "a.ppm", GP_IMAGE_U8, 3 },
    { "a.PPM", GP_IMAGE_U16, 3 }, { "a.pgm", GP_IMAGE_U8, 1 },  { "a.pgm", GP_IMAGE_U16, 1 },
};

#endif
