/* The body of a PLY file: every value is read once, and written again in the plainest form, since
 * OpenMesh 9 misreads many files. It knows no lists beside the corners of faces (which it then takes
 * for single values), no binary coordinates but float, no colours but bytes, no short indices;
 * floating-point colours out of range are undefined behaviour. */
#include "pipeline/io/bytes.h"
#include "pipeline/io/mesh/mesh_ply.h"
#include "pipeline/io/mesh/mesh_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Walk {
    GpMeshSource *source;
    const PlyHeader *header;
    GpText text;       /* next and number, in binary files next only */
    const char *place; /* of the value read last, for messages */
    GpBytes out;       /* the plain file */
    GpError *error;
    const PlyElement *element; /* the present one, for messages */
    size_t item;
} Walk;

static void put_little(GpBytes *out, uint32_t value)
{
    unsigned char bytes[4] = { (unsigned char)value, (unsigned char)(value >> 8),
                               (unsigned char)(value >> 16), (unsigned char)(value >> 24) };
    gp_bytes_append(out, bytes, 4);
}

/* "path: line 5: vertex 2: expected ..." */
static GpResult fail(const Walk *walk, const char *expected)
{
    static const char *const names[] = { "vertex", "face", "element" };
    bool is_ascii = walk->header->encoding == PLY_ASCII;
    return gp_fail(walk->error, GP_ERROR_FORMAT, "%s: %s %zu: %s %zu: expected %s",
                   walk->source->path, is_ascii ? "line" : "byte",
                   is_ascii ? walk->text.number : (size_t)(walk->place - walk->source->file.data),
                   names[walk->element->kind], walk->item, expected);
}

static GpResult read_word(Walk *walk, PlyType type, double *value)
{
    GpWord word;
    char shown[44], expected[96];
    if (!gp_text_any_word(&walk->text, &word))
        return fail(walk, "a number, but the file ends");
    float number;
    int64_t integer;
    bool is_float = type >= PLY_FLOAT32;
    if (is_float ? gp_word_number(&word, &number) : gp_word_integer(&word, &integer)) {
        *value = is_float ? (double)number : (double)integer;
        return GP_OK;
    }
    snprintf(expected, sizeof expected, "%s, found '%s'",
             is_float ? "a finite number" : "an integer", gp_word_show(&word, shown));
    return fail(walk, expected);
}

static double value_of_bits(PlyType type, uint64_t bits)
{
    union {
        uint64_t u;
        double d;
    } pun = { .u = bits };
    switch (type) {
    case PLY_INT8:
        return (int8_t)bits;
    case PLY_INT16:
        return (int16_t)bits;
    case PLY_INT32:
        return (int32_t)bits;
    case PLY_FLOAT32:
        return (double)gp_bits_float((uint32_t)bits);
    case PLY_FLOAT64:
        return pun.d;
    default:
        return (double)bits;
    }
}

/* One value of the file; floating-point values may be anything here. */
static GpResult read_value(Walk *walk, PlyType type, double *value)
{
    walk->place = walk->text.next;
    if (walk->header->encoding == PLY_ASCII)
        return read_word(walk, type, value);
    size_t size = gp_ply_size(type);
    if (size > (size_t)(walk->text.end - walk->text.next))
        return fail(walk, "more bytes, but the file ends");
    uint64_t bits = walk->header->encoding == PLY_BIG ? gp_load_big(walk->text.next, size)
                                                      : gp_load_little(walk->text.next, size);
    *value = value_of_bits(type, bits);
    walk->text.next += size;
    return GP_OK;
}

static GpResult skip_value(Walk *walk, PlyType type)
{
    GpWord word;
    double value;
    if (walk->header->encoding != PLY_ASCII)
        return read_value(walk, type, &value);
    return gp_text_any_word(&walk->text, &word) ? GP_OK : fail(walk, "a number, but the file ends");
}

static GpResult read_length(Walk *walk, const PlyProperty *property, size_t *length)
{
    double value;
    GpResult result = read_value(walk, property->count_type, &value);
    if (result != GP_OK)
        return result;
    double left = (double)(walk->text.end - walk->text.next);
    size_t size = walk->header->encoding == PLY_ASCII ? 1 : gp_ply_size(property->type);
    if (value < 0 || value * (double)size > left)
        return fail(walk, "a list length that fits into the file");
    *length = (size_t)value;
    return GP_OK;
}

static GpResult skip_property(Walk *walk, const PlyProperty *property)
{
    size_t length = 1;
    GpResult result = property->is_list ? read_length(walk, property, &length) : GP_OK;
    for (size_t i = 0; i < length && result == GP_OK; i++)
        result = skip_value(walk, property->type);
    return result;
}

static GpResult check_corners(Walk *walk, const PlyProperty *property)
{
    size_t length = 0;
    GpResult result = read_length(walk, property, &length);
    if (result != GP_OK)
        return result;
    if (length < 3)
        return fail(walk, "3 or more corners");
    put_little(&walk->out, (uint32_t)length);
    for (size_t i = 0; i < length; i++) {
        double index;
        result = read_value(walk, property->type, &index);
        if (result != GP_OK)
            return result;
        if (!(index >= 0 && index < (double)walk->source->vertex_count) || index != floor(index)) {
            char expected[96];
            snprintf(expected, sizeof expected, "a vertex below %zu, but it refers to vertex %.17g",
                     walk->source->vertex_count, index);
            return fail(walk, expected);
        }
        put_little(&walk->out, (uint32_t)index);
    }
    return GP_OK;
}

/* A colour as a byte: integers as they are, floats from 0..1. */
static GpResult check_color(Walk *walk, PlyType type, double value, unsigned char *byte)
{
    bool is_float = type >= PLY_FLOAT32;
    if (!is_float && !(value >= 0 && value <= 255))
        return fail(walk, "a colour in 0..255");
    double scaled = is_float ? value * 255 + 0.5 : value;
    *byte = (unsigned char)(scaled < 0 ? 0 : scaled > 255 ? 255 : scaled);
    return GP_OK;
}

static GpResult check_vertex(Walk *walk)
{
    float value[PLY_RED] = { 0 };
    unsigned char color[4] = { 0, 0, 0, 255 };
    for (size_t i = walk->element->first; i < walk->element->end; i++) {
        const PlyProperty *property = &walk->header->property[i];
        GpResult result;
        double number;
        if (property->role == PLY_IGNORED) {
            result = skip_property(walk, property);
        } else {
            result = read_value(walk, property->type, &number);
            if (result == GP_OK && !isfinite((float)number))
                result = fail(walk, "a finite number");
            if (result == GP_OK && property->role >= PLY_RED)
                result =
                    check_color(walk, property->type, number, &color[property->role - PLY_RED]);
            else if (result == GP_OK)
                value[property->role] = (float)number;
        }
        if (result != GP_OK)
            return result;
    }
    for (int role = 0; role < PLY_RED; role++)
        if (walk->header->has[role])
            put_little(&walk->out, gp_float_bits(value[role]));
    if (walk->header->has[PLY_RED])
        gp_bytes_append(&walk->out, color, 4);
    return GP_OK;
}

static GpResult check_item(Walk *walk)
{
    GpResult result = GP_OK;
    if (walk->element->kind == PLY_VERTEX)
        return check_vertex(walk);
    for (size_t i = walk->element->first; i < walk->element->end && result == GP_OK; i++) {
        const PlyProperty *property = &walk->header->property[i];
        result = property->role == PLY_CORNERS ? check_corners(walk, property)
                                               : skip_property(walk, property);
    }
    return result;
}

/* The header of the plain file; its vertex properties are in the order of PlyRole. */
static void put_header(GpBytes *out, const GpMeshSource *source)
{
    char text[512];
    int size = snprintf(
        text, sizeof text,
        "ply\nformat binary_little_endian 1.0\nelement vertex %zu\n"
        "property float x\nproperty float y\nproperty float z\n%s%s%selement face %zu\n"
        "property list int int vertex_indices\nend_header\n",
        source->vertex_count,
        source->has_normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "",
        source->has_texcoords ? "property float u\nproperty float v\n" : "",
        source->has_colors ? "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                             "property uchar alpha\n"
                           : "",
        source->face_count);
    gp_bytes_append(out, text, (size_t)size);
}

static GpResult walk_body(Walk *walk)
{
    for (size_t i = 0; i < walk->header->element_count; i++) {
        walk->element = &walk->header->element[i];
        for (walk->item = 0; walk->item < walk->element->count; walk->item++) {
            GpResult result = check_item(walk);
            if (result != GP_OK)
                return result;
        }
    }
    GpWord word;
    bool is_ascii = walk->header->encoding == PLY_ASCII;
    if (is_ascii ? gp_text_any_word(&walk->text, &word) : walk->text.next < walk->text.end)
        return gp_fail(walk->error, GP_ERROR_FORMAT,
                       "%s: byte %zu: expected the end of the file after its last element",
                       walk->source->path, (size_t)(walk->text.next - walk->source->file.data));
    return GP_OK;
}

GpResult gp_mesh_check_ply(GpMeshSource *source, GpError *error)
{
    PlyHeader header;
    GpResult result = gp_ply_header(source, &header, error);
    if (result != GP_OK)
        return result;
    for (size_t i = 0; i < header.element_count; i++) {
        if (header.element[i].kind == PLY_VERTEX)
            source->vertex_count = header.element[i].count;
        else if (header.element[i].kind == PLY_FACE)
            source->face_count = header.element[i].count;
    }
    source->has_normals = header.has[PLY_NX];
    source->has_texcoords = header.has[PLY_U];
    source->has_colors = header.has[PLY_RED];

    Walk walk = { .source = source, .header = &header, .error = error };
    size_t before = (size_t)(header.body - source->file.data);
    walk.text = gp_text_begin(source->path, header.body, source->file.size - before, error);
    walk.text.number = header.lines + 1;
    put_header(&walk.out, source);
    result = walk_body(&walk);
    if (result == GP_OK && walk.out.failed)
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for its plain form", source->path);
    if (result != GP_OK) {
        gp_free(walk.out.data);
        return result;
    }
    gp_file_free(&source->file);
    source->file = (GpFile){ .data = walk.out.data, .size = walk.out.size };
    return GP_OK;
}
