#include "pipeline/io/mesh/mesh_ply_header.h"

#include "pipeline/io/mesh/mesh_formats.h"
#include "pipeline/io/mesh/mesh_text.h"

#include <string.h>

static const struct {
    const char *name, *other_name;
    size_t size;
} types[PLY_TYPES] = {
    [PLY_INT8] = { .name = "char", .other_name = "int8", .size = 1 },
    [PLY_UINT8] = { .name = "uchar", .other_name = "uint8", .size = 1 },
    [PLY_INT16] = { .name = "short", .other_name = "int16", .size = 2 },
    [PLY_UINT16] = { .name = "ushort", .other_name = "uint16", .size = 2 },
    [PLY_INT32] = { .name = "int", .other_name = "int32", .size = 4 },
    [PLY_UINT32] = { .name = "uint", .other_name = "uint32", .size = 4 },
    [PLY_FLOAT32] = { .name = "float", .other_name = "float32", .size = 4 },
    [PLY_FLOAT64] = { .name = "double", .other_name = "float64", .size = 8 },
};

/* Names of the vertex properties in use. */
static const struct {
    const char *name;
    PlyRole role;
} vertex_names[] = {
    { "x", PLY_X },
    { "y", PLY_Y },
    { "z", PLY_Z },
    { "nx", PLY_NX },
    { "ny", PLY_NY },
    { "nz", PLY_NZ },
    { "u", PLY_U },
    { "v", PLY_V },
    { "s", PLY_U },
    { "t", PLY_V },
    { "texture_u", PLY_U },
    { "texture_v", PLY_V },
    { "red", PLY_RED },
    { "green", PLY_GREEN },
    { "blue", PLY_BLUE },
    { "alpha", PLY_ALPHA },
    { "diffuse_red", PLY_RED },
    { "diffuse_green", PLY_GREEN },
    { "diffuse_blue", PLY_BLUE },
};

size_t gp_ply_size(PlyType type)
{
    return types[type].size;
}

static bool find_type(const GpWord *word, PlyType *type)
{
    for (int i = 0; i < PLY_TYPES; i++) {
        if (gp_word_is(word, types[i].name) || gp_word_is(word, types[i].other_name)) {
            *type = (PlyType)i;
            return true;
        }
    }
    return false;
}

static GpResult fail(const GpText *text, const char *expected)
{
    return gp_text_fail(text, GP_ERROR_FORMAT, "expected %s", expected);
}

static GpResult parse_format(PlyHeader *header, GpText *text)
{
    static const char *const names[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    GpWord word, version;
    if (!gp_text_line(text) || !gp_text_word(text, &word) || !gp_word_is(&word, "format") ||
        !gp_text_word(text, &word) || !gp_text_word(text, &version) || !gp_word_is(&version, "1.0"))
        return fail(text, "'format', an encoding and '1.0'");
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        if (gp_word_is(&word, names[i])) {
            header->encoding = (PlyEncoding)i;
            return GP_OK;
        }
    }
    return fail(text, "ascii, binary_little_endian or binary_big_endian");
}

static GpResult parse_element(const GpFile *file, PlyHeader *header, GpText *text)
{
    GpWord name, count;
    int64_t number;
    if (!gp_text_word(text, &name) || !gp_text_word(text, &count) ||
        !gp_word_integer(&count, &number) || number < 0)
        return fail(text, "an element's name and count");
    if (number > GP_MESH_COUNT_MAX || number > (int64_t)file->size)
        return gp_text_fail(text, GP_ERROR_FORMAT,
                            "%lld elements are promised, but the file has %zu bytes",
                            (long long)number, file->size);
    if (header->element_count == GP_COUNT(header->element))
        return gp_text_fail(text, GP_ERROR_UNSUPPORTED, "more than %zu elements",
                            GP_COUNT(header->element));
    PlyKind kind = gp_word_is(&name, "vertex") ? PLY_VERTEX
                   : gp_word_is(&name, "face") ? PLY_FACE
                                               : PLY_OTHER;
    bool has_vertices = false;
    for (size_t i = 0; i < header->element_count; i++) {
        has_vertices |= header->element[i].kind == PLY_VERTEX;
        if (kind != PLY_OTHER && header->element[i].kind == kind)
            return fail(text, "one element vertex and one element face");
    }
    if (kind == PLY_FACE && !has_vertices)
        return gp_text_fail(text, GP_ERROR_UNSUPPORTED, "faces before vertices");
    header->element[header->element_count++] = (PlyElement){ .kind = kind,
                                                             .count = (size_t)number,
                                                             .first = header->property_count,
                                                             .end = header->property_count };
    return GP_OK;
}

/* Gives a property its role; the first of several of one role counts. */
static void assign_role(PlyHeader *header, PlyKind kind, const GpWord *name, PlyProperty *property)
{
    if (kind == PLY_VERTEX && !property->is_list) {
        for (size_t i = 0; i < GP_COUNT(vertex_names); i++)
            if (gp_word_is(name, vertex_names[i].name) && !header->has[vertex_names[i].role])
                property->role = vertex_names[i].role;
    } else if (kind == PLY_FACE && property->is_list && !header->has[PLY_CORNERS]) {
        if (gp_word_is(name, "vertex_indices") || gp_word_is(name, "vertex_index"))
            property->role = PLY_CORNERS;
    }
    if (property->role != PLY_IGNORED)
        header->has[property->role] = true;
}

static GpResult parse_property(PlyHeader *header, GpText *text)
{
    PlyProperty property = { .role = PLY_IGNORED };
    GpWord word;
    bool is_valid = gp_text_word(text, &word);
    property.is_list = is_valid && gp_word_is(&word, "list");
    if (property.is_list)
        is_valid = gp_text_word(text, &word) && find_type(&word, &property.count_type) &&
                   property.count_type < PLY_FLOAT32 && gp_text_word(text, &word);
    if (!is_valid || !find_type(&word, &property.type) || !gp_text_word(text, &word))
        return fail(text, "a property's type and name");
    if (header->element_count == 0)
        return fail(text, "an element before its properties");
    if (header->property_count == GP_COUNT(header->property))
        return gp_text_fail(text, GP_ERROR_UNSUPPORTED, "more than %zu properties",
                            GP_COUNT(header->property));
    PlyElement *element = &header->element[header->element_count - 1];
    assign_role(header, element->kind, &word, &property);
    header->property[header->property_count++] = property;
    element->end = header->property_count;
    return GP_OK;
}

/* A group counts only when it is complete: else its members are ignored. */
static bool complete(PlyHeader *header, PlyRole first, PlyRole last)
{
    bool all = true, any = false;
    for (PlyRole role = first; role <= last; role++) {
        all = all && header->has[role];
        any = any || header->has[role];
    }
    if (any && !all) {
        for (size_t i = 0; i < header->property_count; i++) {
            if (header->property[i].role >= first && header->property[i].role <= last)
                header->property[i].role = PLY_IGNORED;
        }
        for (PlyRole role = first; role <= last; role++)
            header->has[role] = false;
    }
    return all;
}

static GpResult finish(PlyHeader *header, GpText *text)
{
    bool has_positions = complete(header, PLY_X, PLY_Z);
    complete(header, PLY_NX, PLY_NZ);
    complete(header, PLY_U, PLY_V);
    bool has_colors = complete(header, PLY_RED, PLY_BLUE);
    if (!has_colors)
        complete(header, PLY_RED, PLY_ALPHA); /* alpha alone is no colour */
    for (size_t i = 0; i < header->element_count; i++) {
        const PlyElement *element = &header->element[i];
        if (element->count > 0 && element->first == element->end)
            return fail(text, "properties for every element");
        if (element->kind == PLY_VERTEX && !has_positions)
            return fail(text, "the vertex properties x, y and z");
        if (element->kind == PLY_FACE && element->count > 0 && !header->has[PLY_CORNERS])
            return fail(text, "the face property list vertex_indices");
    }
    return GP_OK;
}

GpResult gp_ply_header(const char *path, const GpFile *file, PlyHeader *header, GpError *error)
{
    char *begin = file->data;
    GpText text = gp_text_begin(path, begin, file->size, error);
    GpWord word = { .text = NULL, .size = 0 };
    *header = (PlyHeader){ .element_count = 0 };
    bool is_magic = gp_text_line(&text) && gp_text_word(&text, &word) && gp_word_is(&word, "ply");
    if (!is_magic || word.text != begin)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: line 1: expected 'ply'", path);

    GpResult result = parse_format(header, &text);
    while (result == GP_OK) {
        if (!gp_text_line(&text) || !gp_text_word(&text, &word))
            return fail(&text, "'end_header', but the file ends");
        if (gp_word_is(&word, "end_header"))
            break;
        bool is_comment = gp_word_is(&word, "comment"), is_info = gp_word_is(&word, "obj_info");
        if (gp_word_is(&word, "element"))
            result = parse_element(file, header, &text);
        else if (gp_word_is(&word, "property"))
            result = parse_property(header, &text);
        else if (!is_comment && !is_info)
            result = fail(&text, "element, property, comment or end_header");
        if (result == GP_OK && !is_comment && !is_info && gp_text_word(&text, &word))
            result = fail(&text, "nothing more on this line");
    }
    if (result == GP_OK && text.line_end == text.end)
        result = fail(&text, "a line end after 'end_header'");
    if (result != GP_OK)
        return result;

    header->body = text.line_end + 1;
    header->lines = text.number;
    return finish(header, &text);
}
