#include "pipeline/io/volume/volume_file.h"

#include "pipeline/io/bytes.h"
#include "pipeline/io/volume/volume_codec.h"

#include <string.h>

enum { BEST_PACKING = 1040 }; /* deflate makes at most so many bytes of one */

/* --- reading ---------------------------------------------------------------------------------- */

/* What a header asks for is held against what the file has before memory is. */
static GpResult check_size(const GpVolumeSource *source, size_t bytes, GpError *error)
{
    const size_t have = source->file.size - source->body;
    if (source->is_gzip ? bytes / BEST_PACKING <= have : bytes == have)
        return GP_OK;
    return gp_fail(error, GP_ERROR_FORMAT,
                   "%s: byte %zu: %zu bytes of %ssamples, expected those of %u x %u x %u (%zu)",
                   source->path, source->file.size, have, source->is_gzip ? "packed " : "",
                   source->volume.dims[0], source->volume.dims[1], source->volume.dims[2], bytes);
}

static GpResult read_samples(const GpVolumeSource *source, GpVolume *volume, GpError *error)
{
    const size_t bytes = gp_volume_bytes(&source->volume);
    const size_t each = gp_volume_sample_bytes(source->volume.type);
    GpResult result = check_size(source, bytes, error);
    if (result)
        return result;
    void *raw = gp_alloc(bytes, 1);
    void *data = each > 1 ? gp_alloc(bytes, 1) : raw;
    if (!raw || !data)
        result =
            gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %zu bytes", source->path, bytes);
    else if (source->is_gzip)
        result = gp_gzip_unpack(source, raw, bytes, error);
    else
        memcpy(raw, source->file.data + source->body, bytes);
    if (!result && each > 1)
        gp_copy_samples(data, raw, bytes / each, each, source->is_big_endian);
    if (raw != data)
        gp_free(raw);
    if (result) {
        gp_free(data);
        return result;
    }
    *volume = source->volume;
    volume->data = data;
    return GP_OK;
}

/* Whether a path ends so, in any case. */
static bool ends_with(const char *path, const char *end)
{
    size_t length = strlen(path), wanted = strlen(end);
    if (length <= wanted)
        return false;
    for (size_t i = 0; i < wanted; i++) {
        char c = path[length - wanted + i];
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != end[i])
            return false;
    }
    return true;
}

GpResult gp_volume_read(const char *path, GpVolume *volume, GpError *error)
{
    static const struct {
        const char *end;
        GpResult (*parse)(GpVolumeSource *, GpError *);
    } formats[] = { { ".nrrd", gp_volume_parse_nrrd },
                    { ".raw", gp_volume_parse_raw },
                    { ".raw.gz", gp_volume_parse_raw },
                    { ".bits", gp_volume_parse_bits } };
    GP_ASSERT(path && volume);
    size_t i = 0;
    while (i < GP_COUNT(formats) && !ends_with(path, formats[i].end))
        i++;
    if (i == GP_COUNT(formats))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: expected a name that ends with .nrrd, .raw, .raw.gz or .bits", path);
    GpVolumeSource source = { .path = path };
    GpResult result = gp_file_read(path, &source.file, error);
    if (result)
        return result;
    result = formats[i].parse(&source, error);
    if (!result)
        result = read_samples(&source, volume, error);
    gp_file_free(&source.file);
    return result;
}

/* --- writing ---------------------------------------------------------------------------------- */

GpResult gp_volume_write(const char *path, const GpVolume *volume, GpError *error)
{
    GP_ASSERT(path && volume && volume->data);
    const uint32_t *dims = volume->dims;
    if (ends_with(path, ".bits")) {
        if (volume->type != GP_VOLUME_BITS || dims[0] != dims[1] || dims[1] != dims[2])
            return gp_fail(error, GP_ERROR_INVALID,
                           "%s: only a cube of bits goes into a .bits file; .nrrd holds any volume",
                           path);
        return gp_file_write(path, volume->data, gp_volume_bytes(volume), error);
    }
    if (!ends_with(path, ".nrrd"))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: expected a name that ends with .nrrd or .bits", path);
    GpFile file = { .data = NULL };
    GpResult result = gp_volume_encode_nrrd(path, volume, &file, error);
    if (!result)
        result = gp_file_write(path, file.data, file.size, error);
    gp_file_free(&file);
    return result;
}
