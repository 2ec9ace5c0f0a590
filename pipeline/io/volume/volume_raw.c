/* Plain samples: what they are stands in a JSON file beside them. */
#include "pipeline/io/volume/volume_codec.h"

#include <jansson.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* "head.raw.gz" and "head.raw" -> "head.json" */
static bool path_of_json(const char *path, bool is_gzip, char json[PATH_MAX])
{
    size_t stem = strlen(path) - strlen(is_gzip ? ".raw.gz" : ".raw");
    return snprintf(json, PATH_MAX, "%.*s.json", (int)stem, path) < PATH_MAX;
}

/* A member by one of its two names, or NULL. */
static const json_t *member(const json_t *object, const char *name, const char *other)
{
    const json_t *value = json_object_get(object, name);
    return value ? value : json_object_get(object, other);
}

static GpResult read_dims(const char *path, const json_t *object, GpVolume *volume, GpError *error)
{
    const json_t *dims = member(object, "dims", "dims_xyz");
    bool good = json_array_size(dims) == 3;
    for (size_t k = 0; k < 3 && good; k++) {
        const json_t *side = json_array_get(dims, k);
        json_int_t value = json_integer_value(side);
        good = json_is_integer(side) && value >= 1 && value <= GP_VOLUME_MAX_SIDE;
        volume->dims[k] = good ? (uint32_t)value : 0;
    }
    return good ? GP_OK
                : gp_fail(error, GP_ERROR_FORMAT,
                          "%s: dims: expected three whole numbers from 1 to %d", path,
                          GP_VOLUME_MAX_SIDE);
}

static GpResult read_spacing(const char *path, const json_t *object, GpVolume *volume,
                             GpError *error)
{
    const json_t *spacing = member(object, "spacing", "spacing_xyz");
    bool good = !spacing || json_array_size(spacing) == 3;
    for (size_t k = 0; k < 3 && good; k++) {
        volume->spacing[k] = spacing ? json_number_value(json_array_get(spacing, k)) : 1;
        good = isfinite(volume->spacing[k]) && volume->spacing[k] > 0;
    }
    return good ? GP_OK
                : gp_fail(error, GP_ERROR_FORMAT, "%s: spacing: expected three numbers above 0",
                          path);
}

/* "int16", "int16le" or "int16be" */
static GpResult read_type(const char *path, const json_t *object, GpVolumeSource *source,
                          GpError *error)
{
    const char *text = json_string_value(json_object_get(object, "type"));
    char name[32];
    size_t length = text ? strlen(text) : 0;
    bool good = length > 2 && length < sizeof name;
    if (good) {
        const char *end = text + length - 2;
        bool told = strcmp(end, "le") == 0 || strcmp(end, "be") == 0;
        source->is_big_endian = told && *end == 'b';
        snprintf(name, sizeof name, "%.*s", (int)(told ? length - 2 : length), text);
        good = gp_volume_type_of(name, &source->volume.type);
    }
    return good ? GP_OK
                : gp_fail(error, GP_ERROR_FORMAT,
                          "%s: type: expected " GP_VOLUME_TYPES
                          ", with le or be behind, not '%.40s'",
                          path, text ? text : "");
}

static GpResult read_order(const char *path, const json_t *object, GpError *error)
{
    const char *order = json_string_value(json_object_get(object, "order"));
    if (!order || strcmp(order, "x fastest") == 0)
        return GP_OK;
    return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: order: expected \"x fastest\", not '%.40s'",
                   path, order);
}

GpResult gp_volume_parse_raw(GpVolumeSource *source, GpError *error)
{
    char path[PATH_MAX];
    GpFile file;
    source->is_gzip = gp_file_has_extension(source->path, "gz");
    if (!path_of_json(source->path, source->is_gzip, path))
        return gp_fail(error, GP_ERROR_IO, "%.200s: the path is too long", source->path);
    GpResult result = gp_file_read(path, &file, error);
    if (result)
        return result;
    json_error_t reason;
    json_t *object = json_loadb(file.data, file.size, 0, &reason);
    gp_file_free(&file);
    if (!object)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: line %d: %s", path, reason.line, reason.text);
    result = read_dims(path, object, &source->volume, error);
    if (!result)
        result = read_type(path, object, source, error);
    if (!result)
        result = read_spacing(path, object, &source->volume, error);
    if (!result)
        result = read_order(path, object, error);
    json_decref(object);
    return result;
}
