/* What both codecs of OpenImageIO's library share. */
#ifndef GP_IO_OIIO_SHARED_HPP
#define GP_IO_OIIO_SHARED_HPP

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <mutex>
#include <new>
#include <vector>

#include "pipeline/io/image/image_codec.h"

namespace oiio_shared
{
/* Once: no threads of its own. */
inline void configure()
{
    static std::once_flag once;
    std::call_once(once, [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
    });
}

/* The message of a codec is taken in any case: what is left would be printed later. */
inline GpResult fail(const char *path, std::string reason, GpError *error)
{
    for (char &letter : reason)
        letter = letter == '\n' ? ' ' : letter;
    return gp_fail(error, GP_ERROR_FORMAT, "%s: %s", path,
                   reason.empty() ? "not a picture of this format" : reason.c_str());
}

/* A copy of the bytes, for gp_file_free. */
inline void take_bytes(const std::vector<unsigned char> &bytes, GpFile *file)
{
    char *data = static_cast<char *>(gp_alloc(bytes.size(), 1));
    if (!data)
        throw std::bad_alloc();
    std::memcpy(data, bytes.data(), bytes.size());
    file->data = data;
    file->size = bytes.size();
}
} // namespace oiio_shared

/* oiio_layers.cpp; as gp_image_decode_layers and gp_image_encode_layers */
GpResult oiio_decode_layers(const GpImageSource *source, const char *attribute, GpLayers *layers);
GpResult oiio_encode_layers(const char *path, const char *attribute, const GpLayers *layers,
                            GpFile *file, GpError *error);

#endif
