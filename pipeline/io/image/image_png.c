/* PNG read by libpng, in memory. Its errors leave by longjmp, so what must survive one lies in
 * Stream.
 * source ISO/IEC 15948 */
#include "pipeline/io/bytes.h"
#include "pipeline/io/image/image_codec.h"

#include <png.h>
#include <string.h>
#include <zlib.h>

/* --- the header ------------------------------------------------------------------------------- */

static uint32_t big(const unsigned char *at)
{
    return (uint32_t)gp_load_big(at, 4);
}

/* Every chunk must lie in the file and be undamaged, and the last be IEND: a decoder would return
 * what it has. */
static GpResult check_chunks(const GpImageSource *source)
{
    size_t at = 8;
    while (source->file.size - at >= 12) {
        const unsigned char *chunk = gp_image_bytes(source) + at;
        size_t length = big(chunk);
        if (length > source->file.size - at - 12)
            return gp_image_refuse(source, at, "a chunk that fits into the file");
        if (crc32_z(0, chunk + 4, 4 + length) != big(chunk + 8 + length))
            return gp_image_refuse(source, at, "a chunk with the right checksum");
        if (memcmp(chunk + 4, "IEND", 4) == 0)
            return GP_OK;
        at += 12 + length;
    }
    return gp_image_refuse(source, at, "the chunk IEND, but the file ends");
}

GpResult gp_image_check_png(GpImageSource *source)
{
    static const unsigned char magic[16] = { 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n',
                                             0,    0,   0,   13,  'I',  'H',  'D',  'R' };
    const unsigned char *data = gp_image_bytes(source);
    if (source->file.size < 33 || memcmp(data, magic, sizeof magic) != 0)
        return gp_image_refuse(source, 0, "a PNG signature and header");
    static const uint8_t samples[7] = { 1, 0, 3, 1, 2, 0, 4 }; /* by colour type */
    unsigned bits = data[24], color = data[25];
    if (color > 6 || samples[color] == 0 || bits == 0 || bits > 16)
        return gp_image_refuse(source, 24, "a valid bit depth and colour type");
    GpResult result =
        gp_image_take_size(source, big(data + 16), big(data + 20), bits == 16 ? 8 : 4);
    if (result != GP_OK)
        return result;
    /* Deflate makes at most 1032 bytes from one. */
    uint64_t row = ((uint64_t)source->width * bits * samples[color] + 7) / 8 + 1;
    result = gp_image_need_bytes(source, 33, row * source->height / 1032);
    return result == GP_OK ? check_chunks(source) : result;
}

/* --- samples ---------------------------------------------------------------------------------- */

typedef struct Stream {
    const char *path;
    GpError *error;
    GpResult result;
    bool no_memory; /* libpng tells of it in words only, which differ */
    const GpFile *from;
    size_t at; /* in `from` */
    GpImage image;
} Stream;

static void *png_memory(png_structp png, png_alloc_size_t size)
{
    void *memory = gp_alloc_unset(size);
    if (!memory)
        ((Stream *)png_get_mem_ptr(png))->no_memory = true;
    return memory;
}

static void png_release(png_structp png, void *memory)
{
    (void)png;
    gp_free(memory);
}

static void on_error(png_structp png, const char *reason)
{
    Stream *stream = png_get_error_ptr(png);
    stream->result = gp_fail(stream->error, GP_ERROR_FORMAT, "%s: %s", stream->path, reason);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, const char *reason)
{
    (void)png;
    (void)reason;
}

static void read_bytes(png_structp png, png_bytep bytes, size_t size)
{
    Stream *stream = png_get_io_ptr(png);
    if (size > stream->from->size - stream->at)
        png_error(png, "the file ends inside the picture");
    memcpy(bytes, stream->from->data + stream->at, size);
    stream->at += size;
}

static size_t row_bytes(const GpImage *image)
{
    return (size_t)image->width * image->channels * gp_image_sample_size(image->type);
}

/* Palettes, fewer bits and a transparent colour are expanded; an interlaced picture comes in seven
 * passes over the same rows. */
static void read_picture(png_structp png, png_infop info, Stream *stream)
{
    png_set_read_fn(png, stream, read_bytes);
    png_read_info(png, info);
    png_set_expand(png);
    if (!GP_BIG_ENDIAN_MACHINE)
        png_set_swap(png);
    int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    GpImage *image = &stream->image;
    image->width = png_get_image_width(png, info);
    image->height = png_get_image_height(png, info);
    image->channels = png_get_channels(png, info);
    image->type = png_get_bit_depth(png, info) == 16 ? GP_IMAGE_U16 : GP_IMAGE_U8;
    if (gp_image_alloc(image, stream->path, stream->error) != GP_OK)
        return;
    for (int pass = 0; pass < passes; pass++)
        for (size_t y = 0; y < image->height; y++)
            png_read_row(png, (png_bytep)image->data + y * row_bytes(image), NULL);
    png_read_end(png, NULL);
    stream->result = GP_OK;
}

/* What a stream came to; without libpng's structures, or for want of room, it is at
 * GP_ERROR_MEMORY. */
static GpResult finish(Stream *stream)
{
    if (stream->result && stream->no_memory)
        stream->result = GP_ERROR_MEMORY;
    if (stream->result == GP_ERROR_MEMORY)
        gp_fail(stream->error, GP_ERROR_MEMORY, "%s: no memory for the picture", stream->path);
    return stream->result;
}

GpResult gp_image_decode_png(const GpImageSource *source, GpImage *image)
{
    Stream stream = { .path = source->path,
                      .error = source->error,
                      .result = GP_ERROR_MEMORY,
                      .from = &source->file };
    png_structp png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &stream, on_error, on_warning,
                                               &stream, png_memory, png_release);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (info && !setjmp(png_jmpbuf(png)))
        read_picture(png, info, &stream);
    png_destroy_read_struct(&png, &info, NULL);
    if (stream.result == GP_OK)
        *image = stream.image;
    else
        gp_image_free(&stream.image);
    return finish(&stream);
}
