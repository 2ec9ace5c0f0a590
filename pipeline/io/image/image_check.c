/* Headers of picture files, read before a decoder sees them: the magic, the size, and whether the
 * file has enough bytes for it. Decoders allocate what a header asks for. */
#include "pipeline/io/image/image_codec.h"

#include <string.h>

typedef struct Header {
    GpImageSource *source;
    const unsigned char *data;
    size_t size;
    GpError *error;
} Header;

static uint32_t big(const unsigned char *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

static uint32_t little(const unsigned char *at)
{
    return (uint32_t)at[3] << 24 | (uint32_t)at[2] << 16 | (uint32_t)at[1] << 8 | at[0];
}

static GpResult fail(const Header *header, size_t at, const char *expected)
{
    return gp_fail(header->error, GP_ERROR_FORMAT, "%s: byte %zu: expected %s",
                   header->source->path, at, expected);
}

static GpResult unsupported(const Header *header, size_t at, const char *what)
{
    return gp_fail(header->error, GP_ERROR_UNSUPPORTED, "%s: byte %zu: %s", header->source->path,
                   at, what);
}

GpResult gp_image_check_size(const char *path, uint64_t width, uint64_t height, uint64_t pixel_size,
                             GpError *error)
{
    if (width == 0 || height == 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: a picture of %llux%llu pixels", path,
                       (unsigned long long)width, (unsigned long long)height);
    if (width > GP_IMAGE_SIDE_MAX || height > GP_IMAGE_SIDE_MAX ||
        width * height * pixel_size > (uint64_t)1 << 32)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: a picture of %llux%llu pixels is over %d a side or 4 GiB", path,
                       (unsigned long long)width, (unsigned long long)height, GP_IMAGE_SIDE_MAX);
    return GP_OK;
}

static GpResult take_size(const Header *header, uint64_t width, uint64_t height,
                          uint64_t pixel_size)
{
    GpResult result =
        gp_image_check_size(header->source->path, width, height, pixel_size, header->error);
    if (result == GP_OK) {
        header->source->width = (uint32_t)width;
        header->source->height = (uint32_t)height;
    }
    return result;
}

/* At least this many bytes must follow byte at. */
static GpResult need_bytes(const Header *header, size_t at, uint64_t least)
{
    if (at <= header->size && least <= header->size - at)
        return GP_OK;
    return gp_fail(header->error, GP_ERROR_FORMAT,
                   "%s: byte %zu: %ux%u pixels need %llu more bytes, but the file has %zu",
                   header->source->path, at, header->source->width, header->source->height,
                   (unsigned long long)least, header->size > at ? header->size - at : 0);
}

/* --- PNG (ISO/IEC 15948) ----------------------------------------------------------------------- */

/* The checksum of a chunk's name and data, a bit at a time in a table made once per file. */
static void make_crc_table(uint32_t table[256])
{
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t crc = i;
        for (int bit = 0; bit < 8; bit++)
            crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
        table[i] = crc;
    }
}

static uint32_t crc_of(const uint32_t table[256], const unsigned char *bytes, size_t size)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < size; i++)
        crc = crc >> 8 ^ table[(crc ^ bytes[i]) & 255];
    return ~crc;
}

/* Every chunk must lie in the file and be undamaged, and the last be IEND: a decoder would return
 * what it has, or print to the terminal. */
static GpResult check_png_chunks(const Header *header)
{
    uint32_t table[256];
    make_crc_table(table);
    size_t at = 8;
    while (header->size - at >= 12) {
        const unsigned char *chunk = header->data + at;
        uint64_t length = big(chunk);
        if (length > header->size - at - 12)
            return fail(header, at, "a chunk that fits into the file");
        if (crc_of(table, chunk + 4, 4 + (size_t)length) != big(chunk + 8 + length))
            return fail(header, at, "a chunk with the right checksum");
        if (memcmp(chunk + 4, "IEND", 4) == 0)
            return GP_OK;
        at += 12 + (size_t)length;
    }
    return fail(header, at, "the chunk IEND, but the file ends");
}

static GpResult check_png(Header *header)
{
    static const unsigned char magic[16] = { 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n',
                                             0,    0,   0,   13,  'I',  'H',  'D',  'R' };
    const unsigned char *data = header->data;
    if (header->size < 33 || memcmp(data, magic, sizeof magic) != 0)
        return fail(header, 0, "a PNG signature and header");
    static const uint8_t samples[7] = { 1, 0, 3, 1, 2, 0, 4 }; /* by colour type */
    unsigned bits = data[24], color = data[25];
    if (color > 6 || samples[color] == 0 || bits == 0 || bits > 16)
        return fail(header, 24, "a valid bit depth and colour type");
    GpResult result = take_size(header, big(data + 16), big(data + 20), bits == 16 ? 8 : 4);
    if (result != GP_OK)
        return result;
    /* Deflate makes at most 1032 bytes from one. */
    uint64_t row = ((uint64_t)header->source->width * bits * samples[color] + 7) / 8 + 1;
    result = need_bytes(header, 33, row * header->source->height / 1032);
    return result == GP_OK ? check_png_chunks(header) : result;
}

/* --- OpenEXR ------------------------------------------------------------------------------------ */

typedef struct ExrHeader {
    int64_t window[4]; /* x0 y0 x1 y1 of the data window, inclusive */
    unsigned compression;
    uint32_t tile[2];
    bool has_window, has_compression, has_tile;
} ExrHeader;

/* Reads the attributes in use: name, 0, type, 0, size, value, until an empty name. */
static GpResult parse_exr(const Header *header, ExrHeader *exr, size_t *end)
{
    size_t at = 8;
    for (;;) {
        const unsigned char *name = header->data + at;
        size_t left = header->size - at;
        const unsigned char *name_end = memchr(name, 0, left);
        if (!name_end)
            return fail(header, at, "an attribute, but the file ends");
        if (name_end == name)
            break;
        const unsigned char *type = name_end + 1;
        const unsigned char *type_end = memchr(type, 0, left - (size_t)(type - name));
        size_t used = type_end ? (size_t)(type_end + 5 - name) : left;
        if (!type_end || used > left || little(type_end + 1) > left - used)
            return fail(header, at, "an attribute that fits into the file");
        const unsigned char *value = type_end + 5;
        size_t size = little(type_end + 1);
        if (strcmp((const char *)name, "dataWindow") == 0 && size == 16) {
            for (int i = 0; i < 4; i++)
                exr->window[i] = (int32_t)little(value + 4 * i);
            exr->has_window = true;
        } else if (strcmp((const char *)name, "compression") == 0 && size == 1) {
            exr->compression = value[0];
            exr->has_compression = true;
        } else if (strcmp((const char *)name, "tiles") == 0 && size == 9) {
            exr->tile[0] = little(value);
            exr->tile[1] = little(value + 4);
            exr->has_tile = exr->tile[0] > 0 && exr->tile[1] > 0;
        }
        at += used + size;
    }
    *end = at + 1;
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

static GpResult check_exr(Header *header)
{
    if (header->size < 8 || little(header->data) != 20000630)
        return fail(header, 0, "the number of OpenEXR files, 20000630");
    unsigned flags = little(header->data + 4);
    if ((flags & 0xff) != 2 || flags & 0x1800)
        return unsupported(header, 4, "only single-part version 2 pictures are read");

    ExrHeader exr = { .has_window = false };
    size_t end = 0;
    GpResult result = parse_exr(header, &exr, &end);
    if (result != GP_OK)
        return result;
    bool is_tiled = flags & 0x200;
    if (!exr.has_window || !exr.has_compression || exr.compression >= GP_COUNT(exr_compressions) ||
        (is_tiled && !exr.has_tile))
        return fail(header, 8, "a data window, a compression, and tiles in a tiled file");
    int64_t width = exr.window[2] - exr.window[0] + 1, height = exr.window[3] - exr.window[1] + 1;
    result =
        take_size(header, width > 0 ? (uint64_t)width : 0, height > 0 ? (uint64_t)height : 0, 16);
    if (result != GP_OK)
        return result;
    if (is_tiled && (uint64_t)exr.tile[0] * exr.tile[1] > (uint64_t)1 << 24)
        return unsupported(header, 8, "a tile of over 2^24 pixels");

    /* Each block has an offset of 8 bytes in a table and at least 8 bytes before its samples, which
     * are two bytes a pixel or more. */
    uint64_t rows = exr_compressions[exr.compression].rows;
    uint64_t blocks = ((uint64_t)height + rows - 1) / rows;
    if (is_tiled)
        blocks = (((uint64_t)width + exr.tile[0] - 1) / exr.tile[0]) *
                 (((uint64_t)height + exr.tile[1] - 1) / exr.tile[1]);
    uint64_t samples = 2 * (uint64_t)(width * height) / exr_compressions[exr.compression].ratio;
    return need_bytes(header, end, 16 * blocks + samples);
}

/* --- PPM, PGM, PFM: numbers as text between white space ------------------------------------------ */

static bool is_space(unsigned char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Moves *at over white space, and over comments where the format has them; false without any. */
static bool skip_space(const Header *header, size_t *at, bool has_comments)
{
    size_t begin = *at;
    while (*at < header->size) {
        if (has_comments && header->data[*at] == '#') {
            while (*at < header->size && header->data[*at] != '\n')
                ++*at;
        } else if (is_space(header->data[*at])) {
            ++*at;
        } else {
            break;
        }
    }
    return *at > begin;
}

static bool take_number(const Header *header, size_t *at, uint64_t *number)
{
    size_t begin = *at;
    *number = 0;
    for (; *at < header->size && header->data[*at] >= '0' && header->data[*at] <= '9'; ++*at) {
        if (*at - begin > 9)
            return false;
        *number = *number * 10 + (uint64_t)(header->data[*at] - '0');
    }
    return *at > begin;
}

static GpResult check_pnm(Header *header)
{
    GpImageSource *source = header->source;
    bool is_color = source->format == GP_IMAGE_PPM;
    if (header->size < 2 || header->data[0] != 'P' || header->data[1] != (is_color ? '6' : '5'))
        return fail(header, 0, is_color ? "P6" : "P5");
    source->channels = is_color ? 3 : 1;
    size_t at = 2;
    uint64_t number[3];
    for (int i = 0; i < 3; i++) {
        if (!skip_space(header, &at, true) || !take_number(header, &at, &number[i]))
            return fail(header, at, "width, height and the largest value");
    }
    if (number[2] != 255 && number[2] != 65535)
        return unsupported(header, at, "the largest value must be 255 or 65535");
    if (at == header->size || !is_space(header->data[at]))
        return fail(header, at, "white space after the largest value");
    source->type = number[2] == 255 ? GP_IMAGE_U8 : GP_IMAGE_U16;
    source->is_big_endian = true;
    source->body = at + 1;
    uint64_t pixel_size = source->channels * gp_image_sample_size(source->type);
    GpResult result = take_size(header, number[0], number[1], pixel_size);
    return result == GP_OK ? need_bytes(header, source->body, number[0] * number[1] * pixel_size)
                           : result;
}

/* The scale's sign tells the byte order; its size is a unit, which nothing here applies. */
static GpResult check_pfm(Header *header)
{
    GpImageSource *source = header->source;
    if (header->size < 3 || header->data[0] != 'P' ||
        (header->data[1] != 'F' && header->data[1] != 'f'))
        return fail(header, 0, "PF or Pf");
    source->channels = header->data[1] == 'F' ? 3 : 1;
    size_t at = 2;
    uint64_t number[2];
    for (int i = 0; i < 2; i++) {
        if (!skip_space(header, &at, false) || !take_number(header, &at, &number[i]))
            return fail(header, at, "width and height");
    }
    if (!skip_space(header, &at, false) || at == header->size)
        return fail(header, at, "a scale of 1 or -1");
    source->is_big_endian = header->data[at] != '-';
    at += header->data[at] == '-' || header->data[at] == '+';
    uint64_t unit;
    size_t before = at;
    bool is_one = take_number(header, &at, &unit) && unit == 1;
    if (is_one && at < header->size && header->data[at] == '.') {
        at++;
        while (at < header->size && header->data[at] == '0')
            at++;
    }
    if (!is_one || at == header->size || !is_space(header->data[at]))
        return unsupported(header, before, "the scale must be 1 or -1");
    source->type = GP_IMAGE_F32;
    source->body = at + 1;
    GpResult result = take_size(header, number[0], number[1], 4 * source->channels);
    return result == GP_OK
               ? need_bytes(header, source->body, number[0] * number[1] * 4 * source->channels)
               : result;
}

/* --- TGA: no magic at its start, so the header's fields must make sense --------------------------- */

static GpResult check_tga(Header *header)
{
    const unsigned char *data = header->data;
    if (header->size < 18)
        return fail(header, 0, "a TGA header of 18 bytes");
    unsigned map = data[1], type = data[2], bits = data[16];
    bool is_packed = type >= 8;
    unsigned kind = type & 7;
    if (map > 1 || (type & ~11u) || kind == 0)
        return fail(header, 1, "the header of a TGA picture");
    if (map != 0 || (kind != 2 && kind != 3))
        return unsupported(header, 1, "TGA pictures with a palette are not read");
    if (kind == 2 ? bits != 24 && bits != 32 : bits != 8)
        return unsupported(header, 16, "only TGA pictures of 8, 24 or 32 bits are read");
    size_t width = data[12] | (size_t)data[13] << 8, height = data[14] | (size_t)data[15] << 8;
    GpResult result = take_size(header, width, height, 4);
    /* A packet of 1 + bits / 8 bytes makes at most 128 pixels. */
    uint64_t pixels = (uint64_t)width * height;
    uint64_t least = is_packed ? (pixels + 127) / 128 * (1 + bits / 8) : pixels * (bits / 8);
    return result == GP_OK ? need_bytes(header, 18 + (size_t)data[0], least) : result;
}

GpResult gp_image_check(GpImageSource *source, GpError *error)
{
    static GpResult (*const checks[])(Header *) = {
        [GP_IMAGE_PNG] = check_png, [GP_IMAGE_EXR] = check_exr, [GP_IMAGE_PFM] = check_pfm,
        [GP_IMAGE_PPM] = check_pnm, [GP_IMAGE_PGM] = check_pnm, [GP_IMAGE_TGA] = check_tga,
    };
    Header header = { .source = source,
                      .data = (const unsigned char *)source->file.data,
                      .size = source->file.size,
                      .error = error };
    return checks[source->format](&header);
}
