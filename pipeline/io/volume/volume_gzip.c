/* Samples packed by zlib, in gzip's format.
 * source RFC 1952 */
#include "pipeline/io/volume/volume_codec.h"

#include <zlib.h>

enum {
    WINDOW_BITS = 15 + 16, /* 16: gzip's header and checksum, not zlib's */
    MEMORY_LEVEL = 8,      /* zlib's default */
    LEVEL = 4,             /* volumes of voxels are long runs: more effort finds little */
    MAX_PIECE = 1 << 30,   /* zlib counts in unsigned int */
};

/* --- unpacking -------------------------------------------------------------------------------- */

static uInt piece(size_t left)
{
    return (uInt)(left < MAX_PIECE ? left : MAX_PIECE);
}

static GpResult refuse(const GpVolumeSource *source, size_t at, const char *what, GpError *error)
{
    return gp_fail(error, GP_ERROR_FORMAT, "%s: byte %zu: %s", source->path, at, what);
}

static GpResult refuse_short(const GpVolumeSource *source, size_t have, size_t size, GpError *error)
{
    return gp_fail(error, GP_ERROR_FORMAT, "%s: byte %zu: ends after %zu of %zu bytes of samples",
                   source->path, source->file.size, have, size);
}

/* Reads one member after the other: gzip files may be joined. Where all samples are there, one more
 * byte has room, so that zlib finds the end, or shows that it is not there. */
static GpResult inflate_all(const GpVolumeSource *source, z_stream *stream, char *data, size_t size,
                            GpError *error)
{
    const char *begin = source->file.data + source->body;
    const size_t packed = source->file.size - source->body;
    size_t used = 0, have = 0;
    char beyond;
    int status = Z_OK;
    while (used < packed) {
        uInt in = piece(packed - used), out = have < size ? piece(size - have) : 1;
        stream->next_in = (Bytef *)(uintptr_t)(begin + used);
        stream->avail_in = in;
        stream->next_out = (Bytef *)(have < size ? data + have : &beyond);
        stream->avail_out = out;
        status = inflate(stream, Z_NO_FLUSH);
        used += in - stream->avail_in;
        size_t got = out - stream->avail_out;
        if (have == size && got > 0)
            return gp_fail(error, GP_ERROR_FORMAT, "%s: byte %zu: more than %zu bytes of samples",
                           source->path, source->body + used, size);
        have += got;
        if (status == Z_STREAM_END)
            status = inflateReset(stream);
        if (status == Z_MEM_ERROR)
            return gp_fail(error, GP_ERROR_MEMORY, "%s: out of memory", source->path);
        if (status != Z_OK)
            return refuse(source, source->body + used,
                          stream->msg ? stream->msg : "damaged gzip data", error);
    }
    if (have < size)
        return refuse_short(source, have, size, error);
    if (stream->total_in == 0) /* since the last member's end */
        return GP_OK;
    return refuse(source, source->file.size,
                  stream->total_out ? "ends before the checksum of its gzip data"
                                    : "ends with bytes that are no gzip data",
                  error);
}

GpResult gp_gzip_unpack(const GpVolumeSource *source, void *data, size_t size, GpError *error)
{
    z_stream stream = { .next_in = NULL };
    if (inflateInit2(&stream, WINDOW_BITS) != Z_OK)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: out of memory", source->path);
    GpResult result = inflate_all(source, &stream, data, size, error);
    inflateEnd(&stream);
    return result;
}

/* --- packing ---------------------------------------------------------------------------------- */

GpResult gp_gzip_begin(GpGzip *gzip, const void *header, size_t size)
{
    *gzip = (GpGzip){ .stream = gp_alloc(1, sizeof(z_stream)) };
    gp_bytes_append(&gzip->bytes, header, size);
    return gzip->stream && deflateInit2(gzip->stream, LEVEL, Z_DEFLATED, WINDOW_BITS, MEMORY_LEVEL,
                                        Z_DEFAULT_STRATEGY) == Z_OK
               ? GP_OK
               : GP_ERROR_MEMORY;
}

GpResult gp_gzip_add(GpGzip *gzip, const void *data, size_t size, bool is_last)
{
    z_stream *stream = gzip->stream;
    int status = Z_OK;
    GP_ASSERT(size <= MAX_PIECE);
    stream->next_in = (Bytef *)(uintptr_t)data;
    stream->avail_in = (uInt)size;
    do {
        char packed[1 << 14];
        stream->next_out = (Bytef *)packed;
        stream->avail_out = sizeof packed;
        status = deflate(stream, is_last ? Z_FINISH : Z_NO_FLUSH);
        gp_bytes_append(&gzip->bytes, packed, sizeof packed - stream->avail_out);
    } while (stream->avail_in > 0 || (is_last && status != Z_STREAM_END));
    return gzip->bytes.failed ? GP_ERROR_MEMORY : GP_OK;
}

void gp_gzip_end(GpGzip *gzip)
{
    if (gzip->stream)
        deflateEnd(gzip->stream);
    gp_free(gzip->stream);
    gzip->stream = NULL;
}
