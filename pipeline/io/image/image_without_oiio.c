/* Takes OpenImageIO's place in builds without it (make WITH_OIIO=): PPM, PGM and PFM still work. */
#include "pipeline/io/image/image_codec.h"

GpResult gp_image_decode_oiio(const GpImageSource *source, GpImage *image, GpError *error)
{
    (void)image;
    return gp_fail(error, GP_ERROR_UNSUPPORTED,
                   "%s: built without OpenImageIO; only PPM, PGM and PFM can be read",
                   source->path);
}

GpResult gp_image_encode_oiio(const char *path, GpImageFormat format, const GpImage *image,
                              GpFile *file, GpError *error)
{
    (void)format;
    (void)image;
    (void)file;
    return gp_fail(error, GP_ERROR_UNSUPPORTED,
                   "%s: built without OpenImageIO; only PPM and PFM can be written", path);
}
