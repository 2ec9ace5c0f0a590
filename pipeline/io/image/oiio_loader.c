/* OpenImageIO, loaded when a picture needs it: it brings some 250 libraries, which take a fifth of
 * a second to come. It stands in a library of its own, oiio_library.cpp, in ../lib beside the
 * program; a build without it (make WITH_OIIO=) says so here. */
#include "pipeline/io/image/image_codec.h"
#include "pipeline/io/library.h"

#include <fenv.h>
#include <pthread.h>

static const GpImageLibrary *library;
static GpResult loaded;
static GpError reason;

static void load(void)
{
    void *found = NULL;
    loaded = gp_library_find("libglasspipe_oiio.so", "gp_image_oiio", &found, &reason);
    library = found;
}

static GpResult need_library(const char *path, GpError *error)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, load);
    return library
               ? GP_OK
               : gp_fail(error, loaded, "%s: EXR and TGA need OpenImageIO, %s", path, reason.text);
}

/* Libraries and codecs may switch the rounding mode or denormals; pixels must not depend on what
 * was read. */
GpResult gp_image_decode_oiio(const GpImageSource *source, GpImage *image)
{
    fenv_t environment;
    fegetenv(&environment);
    GpResult result = need_library(source->path, source->error);
    if (result == GP_OK)
        result = library->decode(source, image);
    fesetenv(&environment);
    return result;
}

GpResult gp_image_encode_oiio(const char *path, GpImageFormat format, const GpImage *image,
                              struct GpPool *pool, GpFile *file, GpError *error)
{
    (void)pool;
    fenv_t environment;
    fegetenv(&environment);
    GpResult result = need_library(path, error);
    if (result == GP_OK)
        result = library->encode(path, format, image, file, error);
    fesetenv(&environment);
    return result;
}

GpResult gp_image_decode_layers(const GpImageSource *source, const char *attribute,
                                GpLayers *layers)
{
    fenv_t environment;
    fegetenv(&environment);
    GpResult result = need_library(source->path, source->error);
    if (result == GP_OK)
        result = library->decode_layers(source, attribute, layers);
    fesetenv(&environment);
    return result;
}

GpResult gp_image_encode_layers(const char *path, const char *attribute, const GpLayers *layers,
                                GpFile *file, GpError *error)
{
    fenv_t environment;
    fegetenv(&environment);
    GpResult result = need_library(path, error);
    if (result == GP_OK)
        result = library->encode_layers(path, attribute, layers, file, error);
    fesetenv(&environment);
    return result;
}
