/* The headers of OpenEXR files, read before OpenImageIO sees them.
 * source "Technical Introduction to OpenEXR", openexr.com */
#include "pipeline/io/bytes.h"
#include "pipeline/io/image/image_codec.h"

#include <string.h>

static uint32_t little(const unsigned char *at)
{
    return (uint32_t)gp_load_little(at, 4);
}

typedef struct ExrHeader {
    int64_t window[4]; /* x0 y0 x1 y1 of the data window, inclusive */
    unsigned compression;
    uint32_t tile[2];
    uint32_t channels, lists; /* of channels */
    bool has_window, has_compression, has_tile;
} ExrHeader;

/* Channels of a list: name, 0, then sixteen bytes; an empty name ends it. 0: it has none, or no
 * end, or one whose samples are not 32-bit integers, halves or floats: OpenImageIO ends the program
 * over these. */
static uint32_t count_channels(const unsigned char *at, size_t size)
{
    uint32_t count = 0;
    while (size > 0 && *at) {
        const unsigned char *end = memchr(at, 0, size);
        if (!end || size - (size_t)(end - at) < 17 || little(end + 1) > 2)
            return 0;
        size -= (size_t)(end - at) + 17;
        at = end + 17;
        count++;
    }
    return size == 1 ? count : 0;
}

/* Reads the attributes in use: name, 0, type, 0, size, value, until an empty name.
 * in/out at: the first byte of a part's header; that behind it */
static GpResult parse_exr(const GpImageSource *source, ExrHeader *exr, size_t *begin)
{
    size_t at = *begin;
    for (;;) {
        const unsigned char *name = gp_image_bytes(source) + at;
        size_t left = source->file.size - at;
        const unsigned char *name_end = memchr(name, 0, left);
        if (!name_end)
            return gp_image_refuse(source, at, "an attribute, but the file ends");
        if (name_end == name)
            break;
        const unsigned char *type = name_end + 1;
        const unsigned char *type_end = memchr(type, 0, left - (size_t)(type - name));
        size_t used = type_end ? (size_t)(type_end + 5 - name) : left;
        if (!type_end || used > left || little(type_end + 1) > left - used)
            return gp_image_refuse(source, at, "an attribute that fits into the file");
        const unsigned char *value = type_end + 5;
        size_t size = little(type_end + 1);
        if (strcmp((const char *)name, "dataWindow") == 0 && size == 16) {
            for (int i = 0; i < 4; i++)
                exr->window[i] = (int32_t)little(value + 4 * i);
            exr->has_window = true;
        } else if (strcmp((const char *)name, "compression") == 0 && size == 1) {
            exr->compression = value[0];
            exr->has_compression = true;
        } else if (strcmp((const char *)name, "channels") == 0) {
            exr->channels = count_channels(value, size);
            exr->lists++; /* which the library would join */
        } else if (strcmp((const char *)name, "tiles") == 0 && size == 9) {
            exr->tile[0] = little(value);
            exr->tile[1] = little(value + 4);
            exr->has_tile = exr->tile[0] > 0 && exr->tile[1] > 0;
        }
        at += used + size;
    }
    *begin = at + 1;
    return GP_OK;
}

/* By number: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB. The ratios are bounds that no
 * file of that kind can pass: 128 for a run, 1032 for deflate (of 3 bytes where 4 are meant in
 * PXR24), about 400 for PIZ's codes of runs, these on top of 64 to 1 in DWA. */
static const struct {
    uint32_t rows; /* in a block */
    uint32_t ratio;
} exr_compressions[10] = {
    { 1, 1 },     { 1, 128 }, { 1, 1032 }, { 16, 1032 },      { 32, 512 },
    { 16, 1376 }, { 32, 16 }, { 32, 16 },  { 32, 64 * 1032 }, { 256, 64 * 1032 },
};

/* Checks one part's header. in pixel_size: bytes that a decoder takes for a pixel; 0: four a
 * channel
 * in/out at: as parse_exr has it; out: what its data take at least, and have at most */
static GpResult check_part(GpImageSource *source, size_t *at, bool is_tiled, uint64_t pixel_size,
                           uint64_t *least, uint64_t *most)
{
    ExrHeader exr = { .has_window = false };
    const size_t begin = *at;
    GpResult result = parse_exr(source, &exr, at);
    if (result != GP_OK)
        return result;
    if (!exr.has_window || !exr.has_compression || exr.compression >= GP_COUNT(exr_compressions) ||
        (is_tiled && !exr.has_tile))
        return gp_image_refuse(source, begin,
                               "a data window, a compression, and tiles in a tiled file");
    if (exr.channels == 0 || exr.lists != 1)
        return gp_image_refuse(source, begin, "one list of channels of integers, halves or floats");
    pixel_size = pixel_size ? pixel_size : 4 * (uint64_t)exr.channels;
    int64_t width = exr.window[2] - exr.window[0] + 1, height = exr.window[3] - exr.window[1] + 1;
    result = gp_image_take_size(source, width > 0 ? (uint64_t)width : 0,
                                height > 0 ? (uint64_t)height : 0, pixel_size);
    if (result != GP_OK)
        return result;
    if (is_tiled && (uint64_t)exr.tile[0] * exr.tile[1] > (uint64_t)1 << 24)
        return gp_image_unsupported(source, begin, "a tile of over 2^24 pixels");

    /* Each block has an offset of 8 bytes in a table and at least 8 bytes before its samples, which
     * are two bytes a pixel or more. */
    uint64_t rows = exr_compressions[exr.compression].rows;
    uint64_t blocks = ((uint64_t)height + rows - 1) / rows;
    if (is_tiled)
        blocks = (((uint64_t)width + exr.tile[0] - 1) / exr.tile[0]) *
                 (((uint64_t)height + exr.tile[1] - 1) / exr.tile[1]);
    uint64_t samples = 2 * (uint64_t)(width * height) / exr_compressions[exr.compression].ratio;
    *least += 16 * blocks + samples;
    *most += (uint64_t)(width * height) * pixel_size;
    return GP_OK;
}

static GpResult check_version(const GpImageSource *source, unsigned refused, const char *what,
                              unsigned *flags)
{
    *flags = 0;
    if (source->file.size < 8 || little(gp_image_bytes(source)) != 20000630)
        return gp_image_refuse(source, 0, "the number of OpenEXR files, 20000630");
    *flags = little(gp_image_bytes(source) + 4);
    return (*flags & 0xff) != 2 || *flags & refused ? gp_image_unsupported(source, 4, what) : GP_OK;
}

enum { TILED = 0x200, DEEP = 0x800, PARTS = 0x1000 };

GpResult gp_image_check_exr(GpImageSource *source)
{
    unsigned flags;
    size_t at = 8;
    uint64_t least = 0, most = 0;
    GpResult result =
        check_version(source, DEEP | PARTS, "only single-part version 2 pictures are read", &flags);
    if (result == GP_OK)
        result = check_part(source, &at, flags & TILED, 16, &least, &most);
    return result == GP_OK ? gp_image_need_bytes(source, at, least) : result;
}

GpResult gp_image_check_exr_parts(GpImageSource *source)
{
    unsigned flags;
    size_t at = 8;
    uint64_t least = 0, most = 0;
    GpResult result = check_version(source, DEEP | TILED,
                                    "only version 2 pictures of scan lines are read", &flags);
    for (bool more = true; result == GP_OK && more;) {
        result = check_part(source, &at, false, 0, &least, &most);
        more = flags & PARTS && at < source->file.size && source->file.data[at];
    }
    if (result == GP_OK && most > (uint64_t)1 << 32)
        result = gp_image_unsupported(source, 8, "samples of at most 4 GiB are read");
    return result == GP_OK ? gp_image_need_bytes(source, at + (flags & PARTS ? 1 : 0), least)
                           : result;
}
