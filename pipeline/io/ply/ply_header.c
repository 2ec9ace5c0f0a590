#include "pipeline/io/ply/ply_header.h"

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

/* Names of the vertex properties in use, by role. */
static const char *const vertex_names[PLY_VERTEX_ROLES][3] = {
    [PLY_X] = { "x" },
    [PLY_Y] = { "y" },
    [PLY_Z] = { "z" },
    [PLY_NX] = { "nx" },
    [PLY_NY] = { "ny" },
    [PLY_NZ] = { "nz" },
    [PLY_U] = { "u", "s", "texture_u" },
    [PLY_V] = { "v", "t", "texture_v" },
    [PLY_RED] = { "red", "diffuse_red" },
    [PLY_GREEN] = { "green", "diffuse_green" },
    [PLY_BLUE] = { "blue", "diffuse_blue" },
    [PLY_ALPHA] = { "alpha" },
    [PLY_RADIUS] = { "radius" },
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

static bool fail(GpInput *input, const char *expected)
{
    return gp_input_fail(input, GP_ERROR_FORMAT, "expected %s", expected);
}

static bool parse_format(PlyHeader *header, GpInput *input)
{
    static const char *const names[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    GpWord word, version;
    if (!gp_input_line(input) || !gp_input_word(input, &word) || !gp_word_is(&word, "format") ||
        !gp_input_word(input, &word) || !gp_input_word(input, &version) ||
        !gp_word_is(&version, "1.0"))
        return fail(input, "'format', an encoding and '1.0'");
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        header->encoding = (PlyEncoding)i;
        if (gp_word_is(&word, names[i]))
            return true;
    }
    return fail(input, "ascii, binary_little_endian or binary_big_endian");
}

static bool parse_element(PlyHeader *header, GpInput *input)
{
    GpWord name, count;
    int64_t number;
    if (!gp_input_word(input, &name) || !gp_input_word(input, &count) ||
        !gp_word_integer(&count, &number) || number < 0)
        return fail(input, "an element's name and count");
    if (number > GP_INPUT_COUNT_MAX || number > input->end - input->begin)
        return gp_input_fail(input, GP_ERROR_FORMAT,
                             "%lld elements are promised, but the file has %zu bytes",
                             (long long)number, (size_t)(input->end - input->begin));
    if (header->element_count == GP_COUNT(header->element))
        return gp_input_fail(input, GP_ERROR_UNSUPPORTED, "more than %zu elements",
                             GP_COUNT(header->element));
    PlyKind kind = gp_word_is(&name, "vertex") ? PLY_VERTEX
                   : gp_word_is(&name, "face") ? PLY_FACE
                                               : PLY_OTHER;
    bool has_vertices = false;
    for (size_t i = 0; i < header->element_count; i++) {
        has_vertices |= header->element[i].kind == PLY_VERTEX;
        if (kind != PLY_OTHER && header->element[i].kind == kind)
            return fail(input, "one element vertex and one element face");
    }
    if (kind == PLY_FACE && !has_vertices)
        return gp_input_fail(input, GP_ERROR_UNSUPPORTED, "faces before vertices");
    header->element[header->element_count++] = (PlyElement){ .kind = kind,
                                                             .count = (size_t)number,
                                                             .first = header->property_count,
                                                             .end = header->property_count };
    return true;
}

/* What a property means; the first of several of one role counts. */
static PlyRole find_role(const PlyHeader *header, PlyKind kind, const GpWord *name, bool is_list)
{
    for (PlyRole role = 0; kind == PLY_VERTEX && !is_list && role < PLY_VERTEX_ROLES; role++) {
        for (size_t i = 0; i < GP_COUNT(vertex_names[0]) && vertex_names[role][i]; i++)
            if (gp_word_is(name, vertex_names[role][i]))
                return header->has[role] ? PLY_IGNORED : role;
    }
    bool are_corners = kind == PLY_FACE && is_list && !header->has[PLY_CORNERS] &&
                       (gp_word_is(name, "vertex_indices") || gp_word_is(name, "vertex_index"));
    return are_corners ? PLY_CORNERS : PLY_IGNORED;
}

static bool parse_property(PlyHeader *header, GpInput *input)
{
    PlyProperty property = { .role = PLY_IGNORED };
    GpWord word;
    bool is_valid = gp_input_word(input, &word);
    property.is_list = is_valid && gp_word_is(&word, "list");
    if (property.is_list)
        is_valid = gp_input_word(input, &word) && find_type(&word, &property.count_type) &&
                   property.count_type < PLY_FLOAT32 && gp_input_word(input, &word);
    if (!is_valid || !find_type(&word, &property.type) || !gp_input_word(input, &word))
        return fail(input, "a property's type and name");
    if (header->element_count == 0)
        return fail(input, "an element before its properties");
    if (header->property_count == GP_COUNT(header->property))
        return gp_input_fail(input, GP_ERROR_UNSUPPORTED, "more than %zu properties",
                             GP_COUNT(header->property));
    PlyElement *element = &header->element[header->element_count - 1];
    property.role = find_role(header, element->kind, &word, property.is_list);
    header->has[property.role] = true;
    header->property[header->property_count++] = property;
    element->end = header->property_count;
    return true;
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

static bool finish(PlyHeader *header, GpInput *input)
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
            return fail(input, "properties for every element");
        if (element->kind == PLY_VERTEX && !has_positions)
            return fail(input, "the vertex properties x, y and z");
        if (element->kind == PLY_FACE && element->count > 0 && !header->has[PLY_CORNERS])
            return fail(input, "the face property list vertex_indices");
    }
    return true;
}

bool gp_ply_header(GpInput *input, PlyHeader *header)
{
    GpWord word = { .text = NULL, .size = 0 };
    *header = (PlyHeader){ .element_count = 0 };
    bool is_magic = gp_input_line(input) && gp_input_word(input, &word) && gp_word_is(&word, "ply");
    if (!is_magic || word.text != input->begin) {
        input->number = 1;
        return fail(input, "'ply'");
    }
    bool is_valid = parse_format(header, input);
    while (is_valid) {
        if (!gp_input_line(input) || !gp_input_word(input, &word))
            return fail(input, "'end_header', but the file ends");
        if (gp_word_is(&word, "end_header"))
            break;
        if (gp_word_is(&word, "comment") || gp_word_is(&word, "obj_info"))
            continue;
        if (gp_word_is(&word, "element"))
            is_valid = parse_element(header, input);
        else if (gp_word_is(&word, "property"))
            is_valid = parse_property(header, input);
        else
            is_valid = fail(input, "element, property, comment or end_header");
        if (is_valid && gp_input_word(input, &word))
            is_valid = fail(input, "nothing more on this line");
    }
    if (is_valid && input->line_end == input->end)
        is_valid = fail(input, "a line end after 'end_header'");
    if (!is_valid)
        return false;
    input->next = input->line_end + 1;
    return finish(header, input);
}
