#include "pipeline/io/image/image.h"

#include <string.h>

size_t gp_image_sample_size(GpImageType type)
{
    static const size_t sizes[GP_IMAGE_TYPES] = {
        [GP_IMAGE_U8] = 1, [GP_IMAGE_U16] = 2, [GP_IMAGE_F16] = 2, [GP_IMAGE_F32] = 4
    };
    GP_ASSERT((unsigned)type < GP_IMAGE_TYPES);
    return sizes[type];
}

GpResult gp_image_alloc(GpImage *image, const char *path, GpError *error)
{
    image->data = gp_alloc((size_t)image->width * image->height * image->channels,
                           gp_image_sample_size(image->type));
    return image->data ? GP_OK
                       : gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %ux%u pixels", path,
                                 image->width, image->height);
}

void gp_image_free(GpImage *image)
{
    if (!image)
        return;
    gp_free(image->data);
    memset(image, 0, sizeof *image);
}
