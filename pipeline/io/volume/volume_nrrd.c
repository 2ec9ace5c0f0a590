/* NRRD: a header of lines "field: value", an empty line, samples. */
#include "pipeline/io/volume/volume_codec.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char magic[] = "NRRD000"; /* and a version from 1 to 5 */

/* The line that is being read. */
typedef struct Header {
    GpVolumeSource *source;
    unsigned line;
    unsigned seen; /* bit i: field i of the table below */
    GpError *error;
} Header;

static GpResult refuse(const Header *header, GpResult result, const char *expected,
                       const char *value)
{
    return gp_fail(header->error, result, "%s: line %u: expected %s, not '%.60s'",
                   header->source->path, header->line, expected, value);
}

/* --- fields ----------------------------------------------------------------------------------- */

static GpResult read_type(Header *header, const char *value)
{
    if (gp_volume_type_of(value, &header->source->volume.type))
        return GP_OK;
    return refuse(header, GP_ERROR_UNSUPPORTED, "the type " GP_VOLUME_TYPES, value);
}

static GpResult read_dimension(Header *header, const char *value)
{
    if (strcmp(value, "3") == 0)
        return GP_OK;
    return refuse(header, GP_ERROR_UNSUPPORTED, "dimension 3", value);
}

static GpResult read_sizes(Header *header, const char *value)
{
    const char *at = value;
    for (int k = 0; k < 3; k++) {
        char *end;
        errno = 0;
        at += strspn(at, " \t");
        unsigned long long side = *at >= '0' && *at <= '9' ? strtoull(at, &end, 10) : 0;
        if (errno || side < 1 || side > GP_VOLUME_MAX_SIDE)
            return refuse(header, GP_ERROR_FORMAT, "three sizes from 1 to 65535", value);
        header->source->volume.dims[k] = (uint32_t)side;
        at = end;
    }
    if (at[strspn(at, " \t")])
        return refuse(header, GP_ERROR_FORMAT, "three sizes from 1 to 65535", value);
    return GP_OK;
}

static GpResult read_encoding(Header *header, const char *value)
{
    header->source->is_gzip = strcmp(value, "gzip") == 0 || strcmp(value, "gz") == 0;
    if (header->source->is_gzip || strcmp(value, "raw") == 0)
        return GP_OK;
    return refuse(header, GP_ERROR_UNSUPPORTED, "the encoding raw or gzip", value);
}

static GpResult read_endian(Header *header, const char *value)
{
    header->source->is_big_endian = strcmp(value, "big") == 0;
    if (header->source->is_big_endian || strcmp(value, "little") == 0)
        return GP_OK;
    return refuse(header, GP_ERROR_FORMAT, "little or big", value);
}

static bool set_spacing(Header *header, int axis, double spacing)
{
    header->source->volume.spacing[axis] = isnan(spacing) ? 1 : spacing; /* nan: not known */
    return isnan(spacing) || (isfinite(spacing) && spacing > 0);
}

static GpResult read_spacings(Header *header, const char *value)
{
    const char *at = value;
    for (int k = 0; k < 3; k++) {
        char *end;
        double spacing = strtod(at, &end);
        if (end == at || !set_spacing(header, k, spacing))
            return refuse(header, GP_ERROR_FORMAT, "three numbers above 0", value);
        at = end;
    }
    return GP_OK;
}

/* "(1,0,0)". returns what follows; NULL: it is none */
static const char *read_vector(const char *at, double vector[3])
{
    int used = 0;
    if (sscanf(at, " (%lf ,%lf ,%lf )%n", &vector[0], &vector[1], &vector[2], &used) != 3 || !used)
        return NULL;
    return at + used;
}

/* Where steps along each axis lead in space: "(1,0,0) (0,1,0) (0,0,2)". Only their lengths matter
 * here. */
static GpResult read_directions(Header *header, const char *value)
{
    const char *at = value;
    for (int k = 0; k < 3 && at; k++) {
        double step[3];
        at = read_vector(at, step);
        if (at && !set_spacing(header, k,
                               sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2])))
            at = NULL;
    }
    if (!at)
        return refuse(header, GP_ERROR_FORMAT, "three vectors (x,y,z) with some length", value);
    return GP_OK;
}

static GpResult read_origin(Header *header, const char *value)
{
    double *origin = header->source->volume.origin;
    const char *end = read_vector(value, origin);
    if (!end || end[strspn(end, " \t")] || !isfinite(origin[0]) || !isfinite(origin[1]) ||
        !isfinite(origin[2]))
        return refuse(header, GP_ERROR_FORMAT, "a place (x,y,z)", value);
    return GP_OK;
}

static GpResult read_skip(Header *header, const char *value)
{
    if (strcmp(value, "0") == 0)
        return GP_OK;
    return refuse(header, GP_ERROR_UNSUPPORTED, "a skip of 0", value);
}

static GpResult refuse_data_file(Header *header, const char *value)
{
    return refuse(header, GP_ERROR_UNSUPPORTED, "the samples behind the header", value);
}

/* The others tell nothing that is needed here. */
static const struct {
    const char *name, *other;
    bool is_needed;
    GpResult (*read)(Header *, const char *);
} fields[] = {
    { "type", "type", true, read_type },
    { "dimension", "dimension", true, read_dimension },
    { "sizes", "sizes", true, read_sizes },
    { "encoding", "encoding", true, read_encoding },
    { "endian", "endian", false, read_endian },
    { "spacings", "spacings", false, read_spacings },
    { "space directions", "space directions", false, read_directions },
    { "space origin", "space origin", false, read_origin },
    { "line skip", "lineskip", false, read_skip },
    { "byte skip", "byteskip", false, read_skip },
    { "data file", "datafile", false, refuse_data_file },
};

static bool has_seen(const Header *header, const char *name)
{
    for (size_t i = 0; i < GP_COUNT(fields); i++)
        if (strcmp(fields[i].name, name) == 0)
            return header->seen >> i & 1;
    return false;
}

/* --- lines ------------------------------------------------------------------------------------ */

static GpResult read_field(Header *header, char *line)
{
    char *colon = strchr(line, ':');
    if (line[0] == '#' || (colon && colon[1] == '='))
        return GP_OK; /* a comment, or a key of somebody's own */
    if (!colon)
        return refuse(header, GP_ERROR_FORMAT, "a line 'field: value'", line);
    *colon = '\0';
    char *value = colon + 1 + strspn(colon + 1, " \t"), *end = value + strlen(value);
    while (end > value && (end[-1] == ' ' || end[-1] == '\t'))
        *--end = '\0';
    for (size_t i = 0; i < GP_COUNT(fields); i++) {
        if (strcmp(line, fields[i].name) != 0 && strcmp(line, fields[i].other) != 0)
            continue;
        if (header->seen >> i & 1)
            return refuse(header, GP_ERROR_FORMAT, "each field once", line);
        header->seen |= 1u << i;
        return fields[i].read(header, value);
    }
    return GP_OK;
}

/* Ends the line that begins at *at, and moves behind it. NULL at the end of the file. */
static char *next_line(GpFile *file, size_t *at)
{
    char *line = file->data + *at, *end = memchr(line, '\n', file->size - *at);
    if (!end)
        return NULL;
    *at += (size_t)(end - line) + 1;
    *end = '\0';
    if (end > line && end[-1] == '\r')
        end[-1] = '\0';
    return line;
}

static GpResult check_complete(const Header *header)
{
    const GpVolumeSource *source = header->source;
    for (size_t i = 0; i < GP_COUNT(fields); i++)
        if (fields[i].is_needed && !(header->seen >> i & 1))
            return gp_fail(header->error, GP_ERROR_FORMAT,
                           "%s: line %u: the header ends: expected the field '%s'", source->path,
                           header->line, fields[i].name);
    if (gp_volume_sample_bytes(source->volume.type) > 1 && !has_seen(header, "endian"))
        return gp_fail(header->error, GP_ERROR_FORMAT,
                       "%s: line %u: the header ends: expected the field 'endian'", source->path,
                       header->line);
    return GP_OK;
}

GpResult gp_volume_parse_nrrd(GpVolumeSource *source, GpError *error)
{
    Header header = { .source = source, .line = 1, .error = error };
    const char *data = source->file.data;
    char version = source->file.size > sizeof magic ? data[sizeof magic - 1] : '\0';
    if (strncmp(data, magic, sizeof magic - 1) != 0 || version < '1' || version > '5')
        return gp_fail(error, GP_ERROR_FORMAT, "%s: byte 0: expected 'NRRD0001' to 'NRRD0005'",
                       source->path);
    source->volume = (GpVolume){ .spacing = { 1, 1, 1 } };
    GpResult result = GP_OK;
    char *line = next_line(&source->file, &source->body);
    while (!result && line) {
        header.line++;
        line = next_line(&source->file, &source->body);
        if (line && line[0] == '\0')
            return check_complete(&header);
        if (line)
            result = read_field(&header, line);
    }
    if (!result)
        result = gp_fail(error, GP_ERROR_FORMAT,
                         "%s: line %u: the file ends: expected an empty line and samples",
                         source->path, header.line);
    return result;
}

/* --- writing ---------------------------------------------------------------------------------- */

/* Samples stand for cells, and a place is that of a cell's centre, as the format has it. */
static int write_header(const GpVolume *volume, char *text, size_t size)
{
    const double *step = volume->spacing, *origin = volume->origin;
    static const char *const names[] = { [GP_VOLUME_BITS] = "uint8",
                                         [GP_VOLUME_U8] = "uint8",
                                         [GP_VOLUME_U16] = "uint16",
                                         [GP_VOLUME_I16] = "int16",
                                         [GP_VOLUME_F32] = "float" };
    return snprintf(text, size,
                    "NRRD0004\n"
                    "type: %s\n"
                    "dimension: 3\n"
                    "space dimension: 3\n"
                    "sizes: %u %u %u\n"
                    "space directions: (%.17g,0,0) (0,%.17g,0) (0,0,%.17g)\n"
                    "centerings: cell cell cell\n"
                    "kinds: domain domain domain\n"
                    "space origin: (%.17g,%.17g,%.17g)\n"
                    "endian: little\n"
                    "encoding: gzip\n\n",
                    names[volume->type], volume->dims[0], volume->dims[1], volume->dims[2], step[0],
                    step[1], step[2], origin[0], origin[1], origin[2]);
}

/* One row of samples as they stand in the file. */
static void row_bytes(const GpVolume *volume, size_t row, char *bytes)
{
    const size_t width = volume->dims[0], each = gp_volume_sample_bytes(volume->type);
    const unsigned char *data = volume->data;
    if (volume->type != GP_VOLUME_BITS) {
        gp_copy_samples(bytes, data + row * width * each, width, each, false);
        return;
    }
    for (size_t x = 0; x < width; x++) {
        size_t i = row * width + x;
        bytes[x] = data[i / 8] >> i % 8 & 1;
    }
}

GpResult gp_volume_encode_nrrd(const char *path, const GpVolume *volume, GpFile *file,
                               GpError *error)
{
    char header[512];
    const size_t each = gp_volume_sample_bytes(volume->type),
                 rows = (size_t)volume->dims[1] * volume->dims[2];
    const size_t width = volume->dims[0] * (each ? each : 1);
    char *bytes = gp_alloc(width, 1);
    GpGzip gzip;
    GpResult result =
        gp_gzip_begin(&gzip, header, (size_t)write_header(volume, header, sizeof header));
    if (!bytes)
        result = GP_ERROR_MEMORY;
    for (size_t row = 0; row < rows && !result; row++) {
        row_bytes(volume, row, bytes);
        result = gp_gzip_add(&gzip, bytes, width, row + 1 == rows);
    }
    gp_gzip_end(&gzip);
    gp_free(bytes);
    if (result) {
        gp_free(gzip.bytes.data);
        return gp_fail(error, result, "%s: out of memory", path);
    }
    *file = (GpFile){ .data = gzip.bytes.data, .size = gzip.bytes.size };
    return GP_OK;
}
