/* What both codecs of OpenImageIO's library share. */
#ifndef GP_IO_OIIO_SHARED_HPP
#define GP_IO_OIIO_SHARED_HPP

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
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

/* A file's bytes, and none beside them: the library's own reader takes a place before the first,
 * which a damaged table of offsets names, for one inside. */
class FileBytes final : public OIIO::Filesystem::IOProxy
{
  public:
    explicit FileBytes(const GpFile &file) : IOProxy("", Read), file(file)
    {
    }

    const char *proxytype() const override
    {
        return "bytes";
    }
    size_t size() const override
    {
        return file.size;
    }

    bool seek(int64_t offset) override
    {
        m_pos = offset;
        return offset >= 0 && size_t(offset) <= file.size;
    }

    size_t pread(void *to, size_t size, int64_t offset) override
    {
        if (offset < 0 || size_t(offset) > file.size)
            return 0;
        size = std::min(size, file.size - size_t(offset));
        std::memcpy(to, file.data + offset, size);
        return size;
    }

    size_t read(void *to, size_t size) override
    {
        size = pread(to, size, m_pos);
        m_pos += int64_t(size);
        return size;
    }

  private:
    const GpFile &file;
};

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
