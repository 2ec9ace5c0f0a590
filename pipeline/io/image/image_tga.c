/* The headers of TGA files, read before OpenImageIO sees them. There is no magic at their start, so
 * the fields must make sense.
 * source Truevision, "TGA File Format Specification", version 2.0 */
#include "pipeline/io/image/image_codec.h"

GpResult gp_image_check_tga(GpImageSource *source)
{
    const unsigned char *data = gp_image_bytes(source);
    if (source->file.size < 18)
        return gp_image_refuse(source, 0, "a TGA header of 18 bytes");
    unsigned map = data[1], type = data[2], bits = data[16];
    bool is_packed = type >= 8;
    unsigned kind = type & 7;
    if (map > 1 || (type & ~11u) || kind == 0)
        return gp_image_refuse(source, 1, "the header of a TGA picture");
    if (map != 0 || (kind != 2 && kind != 3))
        return gp_image_unsupported(source, 1, "TGA pictures with a palette are not read");
    if (kind == 2 ? bits != 24 && bits != 32 : bits != 8)
        return gp_image_unsupported(source, 16, "only TGA pictures of 8, 24 or 32 bits are read");
    size_t width = data[12] | (size_t)data[13] << 8, height = data[14] | (size_t)data[15] << 8;
    GpResult result = gp_image_take_size(source, width, height, 4);
    /* A packet of 1 + bits / 8 bytes makes at most 128 pixels. */
    uint64_t pixels = (uint64_t)width * height;
    uint64_t least = is_packed ? (pixels + 127) / 128 * (1 + bits / 8) : pixels * (bits / 8);
    return result == GP_OK ? gp_image_need_bytes(source, 18 + (size_t)data[0], least) : result;
}
