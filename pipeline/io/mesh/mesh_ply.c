/* The body of a PLY file: vertices and faces with properties of any type, between what means nothing
 * here. */
#include "pipeline/io/mesh/mesh_formats.h"
#include "pipeline/io/mesh/mesh_ply_header.h"
#include "pipeline/io/mesh/mesh_text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct Walk {
    const char *begin; /* of the file */
    const PlyHeader *header;
    GpText text;       /* next and number, in binary files next only */
    const char *place; /* of the value read last, for messages */
    GpMeshBuilder *mesh;
    const PlyElement *element; /* the present one, for messages */
    size_t item;
} Walk;

/* "path: line 5: vertex 2: expected ..." */
static GpResult fail(const Walk *walk, const char *expected)
{
    static const char *const names[] = { "vertex", "face", "element" };
    bool is_ascii = walk->header->encoding == PLY_ASCII;
    return gp_fail(walk->text.error, GP_ERROR_FORMAT, "%s: %s %zu: %s %zu: expected %s",
                   walk->text.path, is_ascii ? "line" : "byte",
                   is_ascii ? walk->text.number : (size_t)(walk->place - walk->begin),
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

static GpResult read_corners(Walk *walk, const PlyProperty *property)
{
    size_t length = 0;
    GpResult result = read_length(walk, property, &length);
    if (result != GP_OK)
        return result;
    if (length < 3)
        return fail(walk, "3 or more corners");
    gp_mesh_begin_face(walk->mesh);
    for (size_t i = 0; i < length; i++) {
        double index;
        result = read_value(walk, property->type, &index);
        if (result != GP_OK)
            return result;
        if (!(index >= 0 && index < (double)walk->mesh->vertex_count) || index != floor(index)) {
            char expected[96];
            snprintf(expected, sizeof expected, "a vertex below %zu, but it refers to vertex %.17g",
                     walk->mesh->vertex_count, index);
            return fail(walk, expected);
        }
        gp_mesh_add_corner(walk->mesh, (uint32_t)index);
    }
    return GP_OK;
}

/* A colour in 256 steps, as bytes have them: integers of 0..255, or floats, which are clamped. */
static GpResult take_color(const Walk *walk, PlyType type, double value, float *color)
{
    bool is_float = type >= PLY_FLOAT32;
    if (!is_float && !(value >= 0 && value <= 255))
        return fail(walk, "a colour in 0..255");
    double scaled = is_float ? value * 255 + 0.5 : value;
    unsigned char byte = (unsigned char)(scaled < 0 ? 0 : scaled > 255 ? 255 : scaled);
    *color = (float)byte / 255.0f;
    return GP_OK;
}

static GpResult read_vertex(Walk *walk)
{
    float vertex[GP_VERTEX_FLOATS] = { [PLY_ALPHA] = 1 };
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
                result = take_color(walk, property->type, number, &vertex[property->role]);
            else if (result == GP_OK)
                vertex[property->role] = (float)number;
        }
        if (result != GP_OK)
            return result;
    }
    gp_mesh_add_vertex(walk->mesh, vertex);
    return GP_OK;
}

static GpResult read_item(Walk *walk)
{
    GpResult result = GP_OK;
    if (walk->element->kind == PLY_VERTEX)
        return read_vertex(walk);
    for (size_t i = walk->element->first; i < walk->element->end && result == GP_OK; i++) {
        const PlyProperty *property = &walk->header->property[i];
        result = property->role == PLY_CORNERS ? read_corners(walk, property)
                                               : skip_property(walk, property);
    }
    return result;
}

GpResult gp_mesh_read_ply(const char *path, GpFile *file, GpMeshBuilder *mesh, GpError *error)
{
    PlyHeader header;
    GpResult result = gp_ply_header(path, file, &header, error);
    if (result != GP_OK)
        return result;
    mesh->has[GP_MESH_NORMAL] = header.has[PLY_NX];
    mesh->has[GP_MESH_TEXCOORD] = header.has[PLY_U];
    mesh->has[GP_MESH_COLOR] = header.has[PLY_RED];

    Walk walk = { .begin = file->data, .header = &header, .mesh = mesh };
    size_t before = (size_t)(header.body - file->data);
    walk.text = gp_text_begin(path, header.body, file->size - before, error);
    walk.text.number = header.lines + 1;
    for (size_t i = 0; i < header.element_count; i++) {
        const PlyElement *element = walk.element = &header.element[i];
        gp_mesh_builder_reserve(mesh, element->kind == PLY_VERTEX ? element->count : 0,
                                element->kind == PLY_FACE ? element->count : 0);
        for (walk.item = 0; walk.item < element->count; walk.item++) {
            result = read_item(&walk);
            if (result != GP_OK)
                return result;
        }
    }
    GpWord word;
    bool is_ascii = header.encoding == PLY_ASCII;
    if (is_ascii ? gp_text_any_word(&walk.text, &word) : walk.text.next < walk.text.end)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte %zu: expected the end of the file after its last element", path,
                       (size_t)(walk.text.next - file->data));
    return GP_OK;
}
