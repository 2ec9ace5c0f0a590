/* OpenImageIO's codecs on bytes in memory: it opens no file, so what was checked is what is read,
 * and gp_file_write alone decides what appears on the disk. This file is a library of its own,
 * which oiio_loader.c loads. */
#include "pipeline/io/image/oiio_shared.hpp"

#include <memory>

namespace
{
using namespace OIIO;
using namespace oiio_shared;

const struct {
    TypeDesc::BASETYPE base;
    GpImageType type;
} sample_types[] = {
    { TypeDesc::UINT8, GP_IMAGE_U8 },
    { TypeDesc::UINT16, GP_IMAGE_U16 },
    { TypeDesc::HALF, GP_IMAGE_F16 },
    { TypeDesc::FLOAT, GP_IMAGE_F32 },
};

GpResult take_samples(const GpImageSource &source, ImageInput &input, GpImage *image)
{
    GpError *error = source.error;
    const ImageSpec &spec = input.spec();
    GpImage result = {};
    bool is_known = false;
    for (const auto &entry : sample_types) {
        if (entry.base == spec.format.basetype) {
            result.type = entry.type;
            is_known = true;
        }
    }
    if (!is_known || spec.nchannels < 1 || spec.nchannels > 4 || spec.depth > 1 || spec.deep)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: %d channels of %s are not read",
                       source.path, spec.nchannels, spec.format.c_str());
    if (uint32_t(spec.width) != source.width || uint32_t(spec.height) != source.height)
        return fail(source.path, "its header is ambiguous", error);
    result.width = source.width;
    result.height = source.height;
    result.channels = uint32_t(spec.nchannels);
    /* Not touched before there are samples: a header of a few bytes may promise gigabytes of
     * DWA's. */
    result.data = gp_alloc_unset(size_t(result.width) * result.height * result.channels *
                                 gp_image_sample_size(result.type));
    if (!result.data)
        throw std::bad_alloc();
    std::unique_ptr<void, decltype(&gp_free)> samples(result.data, gp_free); /* where it throws */
    /* read_image takes 64 MiB beside the picture to convert; most pictures need no conversion. */
    bool is_native = spec.tile_width == 0 && spec.channelformats.empty();
    bool is_read =
        is_native ? input.read_native_scanlines(0, 0, spec.y, spec.y + spec.height, 0, result.data)
                  : input.read_image(0, 0, 0, spec.nchannels, spec.format, result.data);
    if (!is_read)
        return fail(source.path, input.geterror(), error);
    samples.release();
    *image = result;
    return GP_OK;
}

GpResult decode(const GpImageSource *source, GpImage *image)
{
    GpError *error = source->error;
    try {
        configure();
        ImageSpec config, spec;
        config.attribute("oiio:UnassociatedAlpha", 1);
        FileBytes proxy(source->file);
        auto input = ImageInput::create(source->format == GP_IMAGE_EXR ? "openexr" : "targa");
        if (!input || !input->set_ioproxy(&proxy))
            return fail(source->path, OIIO::geterror(), error);
        GpResult result;
        if (input->open(source->path, spec, config))
            result = take_samples(*source, *input, image);
        else
            result = fail(source->path, input->geterror(), error);
        input->close();
        input->geterror();
        return result;
    } catch (const std::bad_alloc &) {
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %ux%u pixels", source->path,
                       source->width, source->height);
    } catch (const std::exception &problem) {
        return fail(source->path, problem.what(), error);
    }
}

GpResult write_exr(const char *path, const GpImage &image, std::vector<unsigned char> *bytes,
                   GpError *error)
{
    TypeDesc type(image.type == GP_IMAGE_F16 ? TypeDesc::HALF : TypeDesc::FLOAT);
    ImageSpec spec(int(image.width), int(image.height), int(image.channels), type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", ""); /* else the present time is put in */
    auto output = ImageOutput::create("openexr");
    if (!output)
        return fail(path, OIIO::geterror(), error);
    Filesystem::IOVecOutput proxy(*bytes);
    bool is_done = output->set_ioproxy(&proxy) && output->open("picture.openexr", spec) &&
                   output->write_image(type, image.data);
    is_done = output->close() && is_done;
    std::string reason = output->geterror();
    return is_done ? GP_OK : fail(path, reason, error);
}

GpResult encode(const char *path, GpImageFormat, const GpImage *image, GpFile *file, GpError *error)
{
    try {
        configure();
        std::vector<unsigned char> bytes;
        GpResult result = write_exr(path, *image, &bytes, error);
        if (result == GP_OK)
            take_bytes(bytes, file);
        return result;
    } catch (const std::bad_alloc &) {
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory to encode %ux%u pixels", path,
                       image->width, image->height);
    } catch (const std::exception &problem) {
        return fail(path, problem.what(), error);
    }
}
} // namespace

extern "C" const GpImageLibrary gp_image_oiio;
const GpImageLibrary gp_image_oiio = { decode, encode, oiio_decode_layers, oiio_encode_layers };
