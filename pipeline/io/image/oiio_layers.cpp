/* Parts of an EXR file with any channels, on bytes in memory, as oiio_library.cpp has pictures. */
#include "pipeline/io/image/oiio_shared.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
using namespace OIIO;
using namespace oiio_shared;

/* The part that an input stands at. */
GpResult take_layer(const GpImageSource &source, ImageInput &input, int part, const char *attribute,
                    GpLayer *layer)
{
    GpError *error = source.error;
    const ImageSpec &spec = input.spec();
    if (spec.nchannels < 1 || spec.nchannels > GP_LAYER_CHANNELS || spec.depth > 1 || spec.deep ||
        spec.width < 1 || spec.height < 1)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: part %d has %d channels; 1 to %d are read",
                       source.path, part, spec.nchannels, GP_LAYER_CHANNELS);
    const std::string text = spec.get_string_attribute(attribute);
    if (text.size() >= sizeof layer->text)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: part %d: %s is over %zu bytes", source.path,
                       part, attribute, sizeof layer->text - 1);
    std::memcpy(layer->text, text.c_str(), text.size() + 1);
    layer->width = uint32_t(spec.width);
    layer->height = uint32_t(spec.height);
    layer->channel_count = uint32_t(spec.nchannels);
    for (int c = 0; c < spec.nchannels; c++) {
        const std::string &name = spec.channelnames[size_t(c)];
        if (name.size() >= sizeof layer->channel[c])
            return gp_fail(error, GP_ERROR_UNSUPPORTED,
                           "%s: part %d: a channel's name is over %zu bytes", source.path, part,
                           sizeof layer->channel[c] - 1);
        std::memcpy(layer->channel[c], name.c_str(), name.size() + 1);
    }
    layer->samples = static_cast<float *>(gp_alloc_unset(size_t(layer->width) * layer->height *
                                                         layer->channel_count * sizeof(float)));
    if (!layer->samples)
        throw std::bad_alloc();
    return input.read_image(part, 0, 0, spec.nchannels, TypeDesc::FLOAT, layer->samples)
               ? GP_OK
               : fail(source.path, input.geterror(), error);
}

GpResult take_layers(const GpImageSource &source, ImageInput &input, const char *attribute,
                     GpLayers *layers)
{
    GpResult result = GP_OK;
    for (int part = 0; result == GP_OK && input.seek_subimage(part, 0); part++) {
        if (part == GP_LAYERS)
            return gp_fail(source.error, GP_ERROR_UNSUPPORTED,
                           "%s: more than %d parts are not read", source.path, GP_LAYERS);
        layers->count++;
        result = take_layer(source, input, part, attribute, &layers->layer[part]);
    }
    return result;
}

std::vector<ImageSpec> specs_of(const char *attribute, const GpLayers &layers)
{
    std::vector<ImageSpec> specs;
    uint32_t width = 0, height = 0; /* of the display window, which all parts share */
    for (uint32_t i = 0; i < layers.count; i++) {
        width = std::max(width, layers.layer[i].width);
        height = std::max(height, layers.layer[i].height);
    }
    for (uint32_t i = 0; i < layers.count; i++) {
        const GpLayer &layer = layers.layer[i];
        ImageSpec spec(int(layer.width), int(layer.height), int(layer.channel_count),
                       TypeDesc::FLOAT);
        spec.full_width = int(width);
        spec.full_height = int(height);
        spec.channelnames.clear();
        for (uint32_t c = 0; c < layer.channel_count; c++)
            spec.channelnames.push_back(layer.channel[c]);
        spec.alpha_channel = spec.z_channel =
            -1; /* names say what they are; nothing is multiplied */
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", ""); /* else the present time is put in */
        if (layers.count > 1)
            spec.attribute("oiio:subimagename", Strutil::sprintf("part%u", i));
        spec.attribute(attribute, layer.text);
        specs.push_back(spec);
    }
    return specs;
}

/* A file without a place in any folder. OpenImageIO 2.4 writes files of several parts by name only,
 * whatever proxy it is given. */
class MemoryFile
{
  public:
    MemoryFile() : handle(memfd_create("layers", MFD_CLOEXEC))
    {
    }
    ~MemoryFile()
    {
        if (handle >= 0)
            close(handle);
    }
    MemoryFile(const MemoryFile &) = delete;
    MemoryFile &operator=(const MemoryFile &) = delete;

    std::string name() const
    {
        return "/proc/self/fd/" + std::to_string(handle);
    }

    bool read(std::vector<unsigned char> *bytes) const
    {
        struct stat status;
        if (handle < 0 || fstat(handle, &status) != 0)
            return false;
        bytes->resize(size_t(status.st_size));
        size_t at = 0;
        for (ssize_t got = 1; got > 0 && at < bytes->size();
             at += size_t(std::max<ssize_t>(got, 0)))
            got = pread(handle, bytes->data() + at, bytes->size() - at, off_t(at));
        return at == bytes->size();
    }

  private:
    int handle;
};

GpResult write_layers(const char *path, const char *attribute, const GpLayers &layers,
                      std::vector<unsigned char> *bytes, GpError *error)
{
    const std::vector<ImageSpec> specs = specs_of(attribute, layers);
    auto output = ImageOutput::create("openexr");
    if (!output)
        return fail(path, OIIO::geterror(), error);
    const MemoryFile file;
    const std::string name = file.name();
    bool is_done = output->open(name, int(specs.size()), specs.data());
    for (uint32_t i = 0; is_done && i < layers.count; i++)
        is_done = (i == 0 || output->open(name, specs[i], ImageOutput::AppendSubimage)) &&
                  output->write_image(TypeDesc::FLOAT, layers.layer[i].samples);
    is_done = output->close() && is_done;
    const std::string reason = output->geterror();
    return is_done && file.read(bytes) ? GP_OK : fail(path, reason, error);
}
} // namespace

GpResult oiio_decode_layers(const GpImageSource *source, const char *attribute, GpLayers *layers)
{
    GpError *error = source->error;
    GpLayers taken = {};
    GpResult result;
    try {
        configure();
        ImageSpec spec;
        FileBytes proxy(source->file);
        auto input = ImageInput::create("openexr");
        if (!input || !input->set_ioproxy(&proxy))
            return fail(source->path, OIIO::geterror(), error);
        if (input->open(source->path, spec))
            result = take_layers(*source, *input, attribute, &taken);
        else
            result = fail(source->path, input->geterror(), error);
        input->close();
        input->geterror();
    } catch (const std::bad_alloc &) {
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for its pixels", source->path);
    } catch (const std::exception &problem) {
        result = fail(source->path, problem.what(), error);
    }
    if (result == GP_OK)
        *layers = taken;
    else
        gp_layers_free(&taken);
    return result;
}

GpResult oiio_encode_layers(const char *path, const char *attribute, const GpLayers *layers,
                            GpFile *file, GpError *error)
{
    try {
        configure();
        std::vector<unsigned char> bytes;
        GpResult result = write_layers(path, attribute, *layers, &bytes, error);
        if (result == GP_OK)
            take_bytes(bytes, file);
        return result;
    } catch (const std::bad_alloc &) {
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory to encode its pixels", path);
    } catch (const std::exception &problem) {
        return fail(path, problem.what(), error);
    }
}
