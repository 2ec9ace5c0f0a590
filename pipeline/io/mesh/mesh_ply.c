/* The body of a PLY file: vertices and faces with properties of any type, between what means nothing
 * here. */
#include "pipeline/io/mesh/mesh_formats.h"
#include "pipeline/io/mesh/mesh_ply_header.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct Walk {
    GpInput *input;
    const PlyHeader *header;
    GpMeshBuilder *mesh;
    const PlyElement *element; /* the present one, for messages */
    size_t item;
} Walk;

/* "path: line 5: vertex 2: expected ..." */
static void fail(const Walk *walk, const char *expected)
{
    static const char *const names[] = { "vertex", "face", "element" };
    gp_input_fail(walk->input, GP_ERROR_FORMAT, "%s %zu: expected %s", names[walk->element->kind],
                  walk->item, expected);
}

static bool read_word(const Walk *walk, GpWord *word)
{
    if (gp_input_any_word(walk->input, word))
        return true;
    fail(walk, "a number, but the file ends");
    return false;
}

static double value_of_word(const Walk *walk, PlyType type, const GpWord *word)
{
    float number;
    int64_t integer;
    char shown[44], expected[96];
    if (type >= PLY_FLOAT32 && gp_word_number(word, &number))
        return (double)number;
    if (type < PLY_FLOAT32 && gp_word_integer(word, &integer))
        return (double)integer;
    snprintf(expected, sizeof expected, "%s, found '%s'",
             type >= PLY_FLOAT32 ? "a finite number" : "an integer", gp_word_show(word, shown));
    fail(walk, expected);
    return 0;
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

/* One value of the file; floating-point values may be anything here. After a fault, 0. */
static double read_value(const Walk *walk, PlyType type)
{
    GpWord word;
    if (walk->header->encoding == PLY_ASCII)
        return read_word(walk, &word) ? value_of_word(walk, type, &word) : 0;
    size_t size = gp_ply_size(type);
    const char *bytes = gp_input_take(walk->input, size);
    if (!bytes)
        fail(walk, "more bytes, but the file ends");
    else if (walk->header->encoding == PLY_BIG)
        return value_of_bits(type, gp_load_big(bytes, size));
    else
        return value_of_bits(type, gp_load_little(bytes, size));
    return 0;
}

static size_t read_length(const Walk *walk, const PlyProperty *property)
{
    double value = read_value(walk, property->count_type);
    double left = (double)(walk->input->end - walk->input->next);
    size_t size = walk->header->encoding == PLY_ASCII ? 1 : gp_ply_size(property->type);
    if (value >= 0 && value * (double)size <= left)
        return (size_t)value;
    fail(walk, "a list length that fits into the file");
    return 0;
}

static void skip_property(const Walk *walk, const PlyProperty *property)
{
    GpWord word;
    size_t length = property->is_list ? read_length(walk, property) : 1;
    for (size_t i = 0; i < length && walk->input->result == GP_OK; i++) {
        if (walk->header->encoding == PLY_ASCII)
            read_word(walk, &word);
        else
            read_value(walk, property->type);
    }
}

static void read_corners(const Walk *walk, const PlyProperty *property)
{
    size_t length = read_length(walk, property), count = walk->mesh->vertex_count;
    if (length < 3)
        fail(walk, "3 or more corners");
    gp_mesh_begin_face(walk->mesh);
    for (size_t i = 0; i < length && walk->input->result == GP_OK; i++) {
        double index = read_value(walk, property->type);
        if (index >= 0 && index < (double)count && index == floor(index)) {
            gp_mesh_add_corner(walk->mesh, (uint32_t)index);
            continue;
        }
        char expected[96];
        snprintf(expected, sizeof expected, "a vertex below %zu, but it refers to vertex %.17g",
                 count, index);
        fail(walk, expected);
    }
}

/* A colour in 256 steps, as bytes have them: integers of 0..255, or floats, which are clamped. */
static float color_of(const Walk *walk, PlyType type, double value)
{
    bool is_float = type >= PLY_FLOAT32;
    if (!is_float && !(value >= 0 && value <= 255))
        fail(walk, "a colour in 0..255");
    double scaled = is_float ? value * 255 + 0.5 : value;
    unsigned char byte = (unsigned char)(scaled < 0 ? 0 : scaled > 255 ? 255 : scaled);
    return (float)byte / 255.0f;
}

static void read_item(const Walk *walk)
{
    float vertex[GP_VERTEX_FLOATS] = { [PLY_ALPHA] = 1 };
    for (size_t i = walk->element->first; i < walk->element->end; i++) {
        const PlyProperty *property = &walk->header->property[i];
        if (property->role == PLY_CORNERS)
            read_corners(walk, property);
        else if (property->role == PLY_IGNORED)
            skip_property(walk, property);
        if (property->role >= PLY_VERTEX_ROLES)
            continue;
        double value = read_value(walk, property->type);
        if (!isfinite((float)value)) {
            fail(walk, "a finite number");
            return;
        }
        vertex[property->role] =
            property->role >= PLY_RED ? color_of(walk, property->type, value) : (float)value;
    }
    if (walk->element->kind == PLY_VERTEX)
        gp_mesh_add_vertex(walk->mesh, vertex);
}

void gp_mesh_read_ply(GpInput *input, GpMeshBuilder *mesh)
{
    PlyHeader header;
    if (!gp_ply_header(input, &header))
        return;
    mesh->has[GP_MESH_NORMAL] = header.has[PLY_NX];
    mesh->has[GP_MESH_TEXCOORD] = header.has[PLY_U];
    mesh->has[GP_MESH_COLOR] = header.has[PLY_RED];
    bool is_ascii = header.encoding == PLY_ASCII;
    input->number = is_ascii ? input->number + 1 : 0;
    Walk walk = { .input = input, .header = &header, .mesh = mesh };
    for (size_t i = 0; i < header.element_count; i++) {
        const PlyElement *element = walk.element = &header.element[i];
        gp_mesh_builder_reserve(mesh, element->kind == PLY_VERTEX ? element->count : 0,
                                element->kind == PLY_FACE ? element->count : 0);
        for (walk.item = 0; walk.item < element->count && input->result == GP_OK; walk.item++)
            read_item(&walk);
    }
    GpWord word;
    bool is_left = is_ascii ? gp_input_any_word(input, &word) : input->next < input->end;
    input->number = 0;
    input->place = input->next;
    if (is_left)
        gp_input_fail(input, GP_ERROR_FORMAT,
                      "expected the end of the file after its last element");
}
